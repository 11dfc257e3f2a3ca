// Tables of a case file and the look-ups over the schema.
#include "casefile/schema/schema.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace softwet {
namespace {

std::size_t always(const Case&) { return 1; }
void nothing(Case&, std::size_t) {}

template <class Entry>
void grow(std::vector<Entry>& entries, std::size_t index) {
  if (entries.size() <= index) entries.resize(index + 1);
}

/// What Regions::build_mask prescribes.
constexpr const char* boundary_notes =
    R"(A side belongs to the fluid, to the solid, or to both: left is a side of the layer below and of the fluid above.

kind      on the fluid                               on the solid
slip      no velocity through the side,              no motion through the side,
          no shear stress along it                   no shear stress along it (a roller)
no_slip   the velocity is zero                       the displacement stays zero
clamped   the same as no_slip                        the same as no_slip
free      not allowed: the fluid is closed to mass   no stress on the side: it moves freely
periodic  goes on at the opposite side, which must   the same; not from bottom to top
          be periodic too

On every side of the fluid no mass passes and the density has no normal derivative, which is a contact angle of 90
degrees. fluid.contact_angle holds on the wall alone: on top of the solid, or at boundary.bottom where there is none.
)";

std::string bound_text(double number) { return fmt::format("{}", number); }

/// Place of the dot behind the table in a name; npos where there is none.
std::size_t end_of_table(const std::string& name) {
  const auto bracket = name.find("[]");
  return name.find('.', bracket == std::string::npos ? 0 : bracket);
}

/// A case with one of everything, all members at their defaults.
Case default_case() {
  Case c;
  c.domain.size = {1, 1, 1};
  for (const Table& table : tables()) table.open(c, 0);
  return c;
}

}  // namespace

bool Range::contains(double number) const {
  if (!std::isfinite(number)) return false;
  return (low_open ? number > low : number >= low) && (high_open ? number < high : number <= high);
}

std::string Range::text() const {
  if (std::isinf(low) && std::isinf(high)) return {};
  return fmt::format("{}{}, {}{}", low_open ? '(' : '[', bound_text(low), bound_text(high), high_open ? ')' : ']');
}

const std::vector<Table>& tables() {
  static const std::vector<Table> all{
      {"", "", false, true, always, nothing},
      {"domain", "Box of solid and fluid, and its elements", false, true, always, nothing},
      {"fluid", "Isothermal Navier-Stokes-Korteweg; omit for a solid alone", false, true,
       [](const Case& c) -> std::size_t { return c.fluid ? 1 : 0; },
       [](Case& c, std::size_t) {
         if (!c.fluid) c.fluid.emplace();
       }},
      {"substrate", "Elastic solid (2D: plane strain); omit for a rigid wall", false, true,
       [](const Case& c) -> std::size_t { return c.substrate ? 1 : 0; },
       [](Case& c, std::size_t) {
         if (!c.substrate) c.substrate.emplace();
       }},
      {"substrate.branch[]",
       "A spring and a dashpot in series beside the elasticity of the solid; one [[substrate.branch]] each", true,
       false, [](const Case& c) -> std::size_t { return c.substrate ? c.substrate->branches.size() : 0; },
       [](Case& c, std::size_t i) {
         if (!c.substrate) c.substrate.emplace();
         grow(c.substrate->branches, i);
       }},
      {"droplet[]", "Liquid at the start (or vapour: fluid.ambient); one [[droplet]] each", true, true,
       [](const Case& c) { return c.droplets.size(); }, [](Case& c, std::size_t i) { grow(c.droplets, i); }},
      {"film[]", "A box of liquid at the start; one [[film]] each", true, false,
       [](const Case& c) { return c.films.size(); }, [](Case& c, std::size_t i) { grow(c.films, i); }},
      {"wave[]", "A standing wave added to a field at the start; one [[wave]] each", true, false,
       [](const Case& c) { return c.waves.size(); }, [](Case& c, std::size_t i) { grow(c.waves, i); }},
      {"initial", "The state at the start as numbers, expressions or tables, in place of droplets and films", false,
       false, [](const Case& c) -> std::size_t { return c.initial ? 1 : 0; },
       [](Case& c, std::size_t) {
         if (!c.initial) c.initial.emplace();
       }},
      {"load[]", "Force per unit mass on a box of the solid; one [[load]] each", true, true,
       [](const Case& c) { return c.loads.size(); }, [](Case& c, std::size_t i) { grow(c.loads, i); }},
      {"needle[]", "Holds a box of the solid and moves it; one [[needle]] each", true, false,
       [](const Case& c) { return c.needles.size(); }, [](Case& c, std::size_t i) { grow(c.needles, i); }},
      {"probe[]", "A number of each row of history.csv, at a position of your choice; one [[probe]] each", true, false,
       [](const Case& c) { return c.probes.size(); }, [](Case& c, std::size_t i) { grow(c.probes, i); }},
      {"boundary", "What holds on the sides of the domain", false, true, always, nothing, boundary_notes},
      {"time", "Time steps", false, true, always, nothing},
      {"solver", "Newton, Krylov", false, true, always, nothing},
      {"output", "What is written, and when", false, true, always, nothing},
      {"laboratory", "Quantities with units: keys of the case follow from them, and results are shown in such units",
       false, false, [](const Case&) -> std::size_t { return 0; }, nothing},
  };
  return all;
}

const std::vector<Key>& schema() {
  static const std::vector<Key> all = [] {
    std::vector<Key> keys = scene_keys();
    for (Key& key : numerics_keys()) keys.push_back(std::move(key));
    for (Key& key : output_keys()) keys.push_back(std::move(key));
    Parts{}.each([&](const auto& part) {
      for (Key& key : part.keys()) {
        const auto of_table = [&](const Key& other) { return other.table() == key.table(); };
        keys.insert(std::find_if(keys.rbegin(), keys.rend(), of_table).base(), std::move(key));
      }
    });
    for (Key& key : laboratory_keys()) keys.push_back(std::move(key));
    return keys;
  }();
  return all;
}

std::string Key::table() const {
  const auto dot = end_of_table(name);
  return dot == std::string::npos ? std::string{} : name.substr(0, dot);
}

std::string Key::leaf() const {
  const auto dot = end_of_table(name);
  return dot == std::string::npos ? name : name.substr(dot + 1);
}

const Key* find_key(std::string_view name) {
  const auto found = std::find_if(schema().begin(), schema().end(), [&](const Key& key) { return key.name == name; });
  return found == schema().end() ? nullptr : &*found;
}

const Table* find_table(std::string_view name) {
  const auto found = std::find_if(tables().begin(), tables().end(), [&](const Table& t) { return t.name == name; });
  return found == tables().end() ? nullptr : &*found;
}

std::string indexed_name(const std::string& name, std::size_t index) {
  const auto bracket = name.find("[]");
  if (bracket == std::string::npos) return name;
  return fmt::format("{}[{}]{}", name.substr(0, bracket), index, name.substr(bracket + 2));
}

std::string header_of(const Table& table) {
  if (!table.repeated) return fmt::format("[{}]", table.name);
  return fmt::format("[[{}]]", table.name.substr(0, table.name.find('[')));
}

std::string allowed_text(const Key& key) {
  if (key.kind == Kind::choice || key.kind == Kind::names) {
    std::string text = key.kind == Kind::choice ? "one of " : "list of names out of ";
    for (const std::string& choice : key.choices) text += (&choice == &key.choices[0] ? "" : ", ") + in_quotes(choice);
    return text;
  }
  std::string text;
  switch (key.kind) {
    case Kind::number:
      text = "number";
      break;
    case Kind::integer:
      text = "whole number";
      break;
    case Kind::numbers:
      text = "list of numbers";
      break;
    case Kind::times:
      text = "list of numbers and of ranges \"first:last:count\" (count 2 to 10000)";
      break;
    case Kind::integers:
      text = "list of whole numbers";
      break;
    case Kind::box:
      text = "box [[lower corner], [upper corner]]";
      break;
    case Kind::profile:
      text = "number, expression or table (quoted)";
      if (key.support == Support::time) text += ", or a table [[t, value], ...]";
      break;
    case Kind::profiles:
      text = "list of numbers, expressions and tables (quoted), one for each axis";
      if (key.support == Support::time) text += ", or a table [[t, x, y], ...] (in 3D [[t, x, y, z], ...])";
      break;
    default:
      return "text";
  }
  const std::string range = key.range.text();
  return range.empty() ? text : text + " in " + range;
}

std::string facts_text(const Key& key) {
  const std::string unit = key.unit.empty() ? "" : ", in " + key.unit;
  if (key.required) return allowed_text(key) + unit + "; required";
  return allowed_text(key) + unit + "; default " + (key.default_note.empty() ? default_text(key) : key.default_note);
}

std::string default_text(const Key& key) {
  if (key.required) return {};
  return text_of_value(key.bind.get(default_case(), 0));
}

std::string example_text(const Key& key) { return key.example.empty() ? default_text(key) : key.example; }

}  // namespace softwet
