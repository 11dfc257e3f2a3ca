// From a place in Case (a reference to one of its members) to the Binding of a key: conversions to and from Value.
#pragma once

#include <string>
#include <vector>

#include "app/host/schema.hpp"

namespace softwet {

/// Words of the case file for each enumerator, in the order of the enumerators.
inline const std::vector<std::string>& side_words() {
  static const std::vector<std::string> words{"slip", "no_slip", "clamped", "free", "periodic"};
  return words;
}
inline const std::vector<std::string>& wall_law_words() {
  static const std::vector<std::string> words{"gradient", "energy"};
  return words;
}

inline const std::vector<std::string>& phase_words() {
  static const std::vector<std::string> words = {"vapour", "liquid"};
  return words;
}

inline const std::vector<std::string>& traction_words() {
  static const std::vector<std::string> words = {"layer", "blended"};
  return words;
}

inline std::size_t position_of(const std::vector<std::string>& words, const std::string& word) {
  std::size_t position = 0;
  while (position + 1 < words.size() && words[position] != word) ++position;
  return position;
}

// Member <- value. The reader has checked kind and range before.
inline void store(double& member, const Value& value) { member = std::get<double>(value); }
inline void store(int& member, const Value& value) { member = static_cast<int>(std::get<double>(value)); }
inline void store(long& member, const Value& value) { member = static_cast<long>(std::get<double>(value)); }
inline void store(std::string& member, const Value& value) { member = std::get<std::string>(value); }
inline void store(Numbers& member, const Value& value) { member = std::get<Numbers>(value); }
inline void store(Words& member, const Value& value) { member = std::get<Words>(value); }
inline void store(std::vector<int>& member, const Value& value) {
  const Numbers& numbers = std::get<Numbers>(value);
  member.assign(numbers.begin(), numbers.end());
}
inline void store(Side& member, const Value& value) {
  member = static_cast<Side>(position_of(side_words(), std::get<std::string>(value)));
}
inline void store(Traction& member, const Value& value) {
  member = static_cast<Traction>(position_of(traction_words(), std::get<std::string>(value)));
}
inline void store(Phase& member, const Value& value) {
  member = static_cast<Phase>(position_of(phase_words(), std::get<std::string>(value)));
}
inline void store(WallLaw& member, const Value& value) {
  member = static_cast<WallLaw>(position_of(wall_law_words(), std::get<std::string>(value)));
}

// Value <- member.
inline Value load(double member) { return member; }
inline Value load(int member) { return static_cast<double>(member); }
inline Value load(long member) { return static_cast<double>(member); }
inline Value load(const std::string& member) { return member; }
inline Value load(const Numbers& member) { return member; }
inline Value load(const Words& member) { return member; }
inline Value load(const std::vector<int>& member) { return Numbers(member.begin(), member.end()); }
inline Value load(Side member) { return side_words()[static_cast<std::size_t>(member)]; }
inline Value load(Traction member) { return traction_words()[static_cast<std::size_t>(member)]; }
inline Value load(Phase member) { return phase_words()[static_cast<std::size_t>(member)]; }
inline Value load(WallLaw member) { return wall_law_words()[static_cast<std::size_t>(member)]; }

/// Binding of the member that `place(case, index)` refers to.
template <class Place>
Binding at(Place place) {
  return {[place](Case& c, std::size_t index, const Value& value) { store(place(c, index), value); },
          [place](const Case& c, std::size_t index) { return load(place(const_cast<Case&>(c), index)); }};
}

/// A box is two lists in an entry of Case, lower and upper corner; `place` returns the entry.
template <class Place>
Binding box_of(Place place) {
  return {[place](Case& c, std::size_t index, const Value& value) {
            const auto& corners = std::get<std::vector<Numbers>>(value);
            place(c, index).lower = corners[0];
            place(c, index).upper = corners[1];
          },
          [place](const Case& c, std::size_t index) {
            const auto& entry = place(const_cast<Case&>(c), index);
            return std::vector<Numbers>{entry.lower, entry.upper};
          }};
}

}  // namespace softwet
