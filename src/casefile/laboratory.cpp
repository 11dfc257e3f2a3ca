#include "casefile/laboratory.hpp"

#include <fmt/core.h>

#include <string>
#include <vector>

#include "casefile/schema/laboratory_quantities.hpp"

namespace softwet {
namespace {

const Entry* find(const Document& document, const std::string& name) {
  const auto found = document.entries.find(name);
  return found == document.entries.end() ? nullptr : &found->second;
}

bool is_set(const Entry& entry) { return entry.place.rfind("--set ", 0) == 0; }

double quantity_of(const Entry& entry, const LaboratoryQuantity& f) {
  const std::string& text = std::get<std::string>(entry.value);
  if (const auto si = si_from(f.quantity, text)) return *si;
  reject(entry.place, f.key(), text, problem_with(f.quantity, text),
         fmt::format("write for example {} = {}", f.name, entry.key->example));
}

/// What the scales need, and cannot do without.
void require_scales(const Document& document) {
  const auto place = document.table_place.find("laboratory");
  const std::string& where = place == document.table_place.end() ? document.place : place->second;
  if (!document.table_count.count("fluid"))
    reject(where, "laboratory", "", "the scales of a case follow from its liquid, and the case has none",
           "add a table [fluid], or remove [laboratory]");
  for (std::size_t i = 0; i < quantities_of_scales; ++i) {
    const LaboratoryQuantity& f = laboratory_quantities()[i];
    if (!find(document, f.key()))
      reject(where, f.key(), "", "is missing, and the scales of the case follow from it",
             fmt::format("write for example {} = {}", f.name, find_key(f.key())->example));
  }
  if (!find(document, "fluid.temperature"))
    reject(where, "fluid.temperature", "", "is missing, and the scales of the case follow from it",
           "write for example temperature = 0.39");
  if (!find(document, "fluid.capillarity") && !find(document, "laboratory.capillarity"))
    reject(where, "laboratory.capillarity", "", "is missing: the width of the interface sets the scale of all stresses",
           "write half of it, for example capillarity = \"10 um\"");
}

/// Whether a key follows from a quantity: not where the command line has given the key itself. Refuses both in one place.
bool follows(const Document& document, const LaboratoryQuantity& f, const Entry& quantity, const std::string& key) {
  if (key == "substrate.density" && std::string(f.name) == "young" && find(document, "laboratory.solid_density"))
    return false;
  const Entry* given = find(document, indexed_name(key, 0));
  if (!given) return true;
  if (is_set(*given) == is_set(quantity))
    reject(given->place, indexed_name(key, 0), given->text,
           fmt::format("follows from {} = {} too ({})", f.key(), quantity.text, quantity.place), "keep one of the two");
  return is_set(quantity);
}

/// To 15 digits: 100 um over 500 um is 0.2, and not 0.19999999999999998.
double without_last_digit(double number) { return *number_from_text(fmt::format("{:.15g}", number)); }

void enter(Document& document, const LaboratoryQuantity& f, const std::string& name, const Case& numbers) {
  const Key& key = *find_key(name);
  const Entry quantity = *find(document, f.key());
  const std::string table = key.table();
  if (find_table(table)->repeated && !document.table_count.count(table))
    reject(quantity.place, f.key(), quantity.text, fmt::format("gives {}, and the case has no such table", name),
           fmt::format("add {} with its other keys", header_of(*find_table(table))));
  document.table_count.emplace(table, 1);
  const double number = without_last_digit(std::get<double>(key.bind.get(numbers, 0)));
  Entry entry = entry_of_number(key, 0, number, quantity.place);
  entry.text = fmt::format("{}, from {} = {}", entry.text, f.key(), quantity.text);
  document.entries[indexed_name(name, 0)] = entry;
}

/// The quantities in SI units, with the numbers of the case that the scales depend on.
PhysicalScene scene_of(const Document& document, Problems& problems) {
  PhysicalScene scene;
  for (const LaboratoryQuantity& f : laboratory_quantities())
    if (const Entry* entry = find(document, f.key())) problems.keep([&] { scene.*f.place = quantity_of(*entry, f); });
  problems.keep([&] { require_scales(document); });
  problems.throw_if_any();
  scene.temperature = std::get<double>(find(document, "fluid.temperature")->value);
  if (const Entry* given = find(document, "fluid.capillarity")) {
    const Entry* quantity = find(document, "laboratory.capillarity");
    if (!quantity || !is_set(*quantity)) scene.capillarity = std::get<double>(given->value);
  }
  return scene;
}

}  // namespace

std::optional<Laboratory> follow_laboratory(Document& document, const Conversion& conversion, Problems& problems) {
  if (!document.table_count.count("laboratory")) return {};
  const PhysicalScene scene = scene_of(document, problems);
  const Case numbers = conversion.numbers(scene);
  for (const LaboratoryQuantity& f : laboratory_quantities()) {
    const auto quantity = document.entries.find(f.key());
    if (quantity == document.entries.end()) continue;
    for (const std::string& key : f.keys)
      problems.keep([&] {
        if (follows(document, f, quantity->second, key)) enter(document, f, key, numbers);
      });
  }
  problems.throw_if_any();
  Laboratory found{conversion.scales(scene), "\n[laboratory]\n"};
  for (std::size_t i = 0; i < quantities_of_scales; ++i) {
    const LaboratoryQuantity& f = laboratory_quantities()[i];
    found.table += fmt::format("{} = {}\n", f.name, text_of_value(find(document, f.key())->value));
  }
  return found;
}

}  // namespace softwet
