// From a place in Case (a reference to one of its members) to the Binding of a key: conversions to and from Value.
#pragma once

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

#include "casefile/schema.hpp"

namespace softwet {

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
template <class Enumeration>
  requires std::is_enum_v<Enumeration>
void store(Enumeration& member, const Value& value) {
  const std::vector<std::string> words = words_of(Enumeration{});
  member =
      static_cast<Enumeration>(std::find(words.begin(), words.end(), std::get<std::string>(value)) - words.begin());
}

// Value <- member.
inline Value load(double member) { return member; }
inline Value load(int member) { return static_cast<double>(member); }
inline Value load(long member) { return static_cast<double>(member); }
inline Value load(const std::string& member) { return member; }
inline Value load(const Numbers& member) { return member; }
inline Value load(const Words& member) { return member; }
inline Value load(const std::vector<int>& member) { return Numbers(member.begin(), member.end()); }
template <class Enumeration>
  requires std::is_enum_v<Enumeration> Value load(Enumeration member) {
    return words_of(member)[static_cast<std::size_t>(member)];
  }

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
