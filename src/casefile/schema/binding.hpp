// From a place in Case (a reference to one of its members) to the Binding of a key: conversions to and from Value.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "casefile/schema/schema.hpp"

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
inline void store(Profile& member, const Value& value) {
  member = Profile{member.number};
  if (const auto* text = std::get_if<std::string>(&value)) {
    member.text = *text;  // the formula follows when the whole case is known
  } else {
    member.number = std::get<double>(value);
  }
}
inline void store(std::optional<Profile>& member, const Value& value) {
  member.reset();
  if (value != Value(std::string{})) store(member.emplace(), value);
}
inline void store(std::vector<Profile>& member, const Value& value) {
  member.clear();
  for (const std::string& text : std::get<Words>(value)) {
    const auto number = number_from_text(text);
    store(member.emplace_back(), number ? Value(*number) : Value(text));
  }
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
inline Value load(const Profile& member) { return member.text.empty() ? Value(member.number) : Value(member.text); }
inline Value load(const std::optional<Profile>& member) { return member ? load(*member) : Value(std::string{}); }
inline Value load(const std::vector<Profile>& member) {
  Words texts;
  for (const Profile& profile : member)
    texts.push_back(profile.text.empty() ? text_of_number(profile.number) : profile.text);
  return texts;
}
template <class Enumeration>
  requires std::is_enum_v<Enumeration> Value load(Enumeration member) { return word_of(member); }

// The profiles in a member.
inline std::vector<Profile*> profiles_in(Profile& member) { return {&member}; }
inline std::vector<Profile*> profiles_in(std::optional<Profile>& member) {
  return member ? std::vector<Profile*>{&*member} : std::vector<Profile*>{};
}
inline std::vector<Profile*> profiles_in(std::vector<Profile>& member) {
  std::vector<Profile*> all;
  for (Profile& profile : member) all.push_back(&profile);
  return all;
}

/// Binding of a member that is a profile, or has some.
template <class Place>
Binding profile_at(Place place) {
  return {[place](Case& c, std::size_t index, const Value& value) { store(place(c, index), value); },
          [place](const Case& c, std::size_t index) { return load(place(const_cast<Case&>(c), index)); },
          [place](Case& c, std::size_t index) { return profiles_in(place(c, index)); }};
}

/// Binding of the member that `place(case, index)` refers to.
template <class Place>
Binding at(Place place) {
  return {[place](Case& c, std::size_t index, const Value& value) { store(place(c, index), value); },
          [place](const Case& c, std::size_t index) { return load(place(const_cast<Case&>(c), index)); },
          {}};
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
          },
          {}};
}

}  // namespace softwet
