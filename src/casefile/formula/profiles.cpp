// Profiles of a case.
#include "casefile/formula/profiles.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "casefile/formula/expression.hpp"
#include "casefile/formula/grid_table.hpp"
#include "io/run_record.hpp"

namespace softwet {
namespace {

constexpr double most_places = 2e6;  ///< at which a profile that varies in space is looked at
constexpr int points_in_time = 2001;
constexpr double largest_value = 1e30;  ///< of a value in size

Vocabulary vocabulary(const Case& c, Support support) {
  const std::vector<std::string> axes{"x", "y", "z"}, lengths{"Lx", "Ly", "Lz"};
  const std::size_t dimension = c.domain.size.size();
  Vocabulary known;
  known.variables = {"t"};
  if (support != Support::time) known.variables.assign(axes.begin(), axes.begin() + dimension);
  known.constants = {{"pi", std::acos(-1.0)}};
  for (std::size_t d = 0; d < dimension; ++d) known.constants.emplace_back(lengths[d], c.domain.size[d]);
  known.constants.emplace_back("H", c.wall_height());
  if (c.fluid) known.constants.emplace_back("g", c.fluid->capillarity);
  known.constants.emplace_back("h", c.spacing());
  return known;
}

/// Where along an axis a profile is looked at.
struct Span {
  double low, high;
  int elements;

  std::vector<double> points(double for_each_element) const {
    const int steps = elements == 0 ? 0 : std::max(1, static_cast<int>(elements * for_each_element));
    std::vector<double> x{low};
    for (int i = 1; i <= steps; ++i) x.push_back(i == steps ? high : low + (high - low) * i / steps);
    return x;
  }
};

std::array<Span, 3> spans_of(const Case& c, Support support) {
  std::array<Span, 3> spans{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
  const std::size_t vertical = c.domain.size.size() - 1;
  for (std::size_t d = 0; d < vertical; ++d) spans[d] = {0, c.domain.size[d], c.domain.elements[d]};
  const double wall = c.wall_height(), height = c.domain.size[vertical];
  const int all = c.domain.elements[vertical], below = static_cast<int>(std::lround(wall / height * all));
  if (support == Support::solid) spans[vertical] = {0, wall, below};
  if (support == Support::fluid) spans[vertical] = {wall, height, all - below};
  if (support == Support::wall) spans[vertical] = {wall, wall, 0};
  return spans;
}

template <class Visit>
void visit_space(const Case& c, Support support, const Visit& visit) {
  const std::array<Span, 3> spans = spans_of(c, support);
  double density = 2, count = 1;
  for (const Span& span : spans) count *= 2.0 * span.elements + 1;
  if (count > most_places) density *= std::pow(most_places / count, 1.0 / c.dimension());
  for (const double z : spans[2].points(density))
    for (const double y : spans[1].points(density))
      for (const double x : spans[0].points(density)) visit({x, y, z}, 0.0);
}

/// Time of the results at which a load begins to act; a needle does so at t = 0.
double first_time(const Case& c, const Key& key, std::size_t index) {
  return key.table() == "load[]" ? c.loads[index].start - c.clock_zero() : 0;
}

template <class Visit>
void visit_time(const Case& c, double begin, const std::vector<double>& kinks, const Visit& visit) {
  const double end = std::max(c.time.end, begin);
  for (int i = 0; i < points_in_time; ++i) visit({0, 0, 0}, begin + (end - begin) * i / (points_in_time - 1));
  for (const double t : kinks)
    if (t >= begin && t <= end) visit({0, 0, 0}, t);
}

std::string place_text(const Case& c, Support support, const std::array<double, 3>& x, double t) {
  if (support == Support::time) return fmt::format("t = {:.6g}", t);
  std::string text;
  for (int d = 0; d < c.dimension(); ++d) text += fmt::format("{}{:.6g}", d ? ", " : "(", x[d]);
  return text + ")";
}

class ProfileBuilder {
 public:
  ProfileBuilder(Case& c, const Document& document, Tables tables) : c_(c), document_(document), tables_(tables) {}

  void build(const Key& key, std::size_t index) {
    const auto found = document_.entries.find(indexed_name(key.name, index));
    if (found == document_.entries.end()) return;
    const std::vector<Profile*> all = key.bind.profiles(c_, index);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::string component = all.size() > 1 ? fmt::format("number {} of the list: ", i + 1) : "";
      try {
        give_formula(key, *all[i]);
        const bool left = GridTable::is_path(all[i]->text) && !all[i]->formula;
        if (!left) check_values(key, index, *all[i]);
      } catch (const FormulaError& error) {
        reject(found->second.place, indexed_name(key.name, index), found->second.text, component + error.what(),
               error.remedy);
      }
    }
  }

 private:
  void give_formula(const Key& key, Profile& profile) const {
    if (profile.text.empty()) return;
    const Vocabulary known = vocabulary(c_, key.support);
    if (GridTable::is_path(profile.text)) {
      const std::filesystem::path folder = std::filesystem::path(document_.place).parent_path();
      profile.text = std::filesystem::absolute(folder / profile.text).lexically_normal().string();
      if (tables_ == Tables::leave) return;
      profile.formula = std::make_shared<GridTable>(profile.text, known.variables);
      return;
    }
    if (GridTable::is_pairs(profile.text)) {
      if (key.support != Support::time)
        throw FormulaError("is a table over time, but this number does not vary in time",
                           "write an expression in quotes, or the path of a table");
      profile.formula = std::make_shared<GridTable>(GridTable::of_pairs(profile.text));
      return;
    }
    if (GridTable::is_other_file(profile.text))
      throw FormulaError("is not a table that can be read",
                         "save it as CSV in UTF-8, in Excel as 'CSV UTF-8', under a name that ends with .csv");
    const auto expression = std::make_shared<Expression>(profile.text, known);
    if (expression->constant()) {
      profile.number = expression->at({0, 0, 0}, 0) + 0.0;  // zero has no sign
    } else {
      profile.formula = expression;
    }
  }

  void check_values(const Key& key, std::size_t index, Profile& profile) const {
    profile.lowest = infinity, profile.highest = -infinity;
    const auto look = [&](const std::array<double, 3>& x, double t) {
      const double value = profile.at(x, t);
      if (!std::isfinite(value) || std::abs(value) > largest_value || !key.range.contains(value))
        refuse_value(key, profile, value, place_text(c_, key.support, x, t));
      profile.lowest = std::min(profile.lowest, value);
      profile.highest = std::max(profile.highest, value);
    };
    if (!profile.varies()) {
      look({0, 0, 0}, 0);
    } else if (key.support == Support::time) {
      visit_time(c_, first_time(c_, key, index), profile.formula->kinks(), look);
    } else {
      visit_space(c_, key.support, look);
    }
  }

  [[noreturn]] void refuse_value(const Key& key, const Profile& profile, double value, const std::string& place) const {
    const std::string where = profile.varies() ? " at " + place : "", range = key.range.text();
    const std::string reason = key.reason.empty() ? "" : key.reason + "; ";
    throw FormulaError(
        fmt::format("is {:.6g}{} and must be a number{}", value, where, range.empty() ? "" : " in " + range),
        reason + "bound it there, for example with max and min");
  }

  Case& c_;
  const Document& document_;
  Tables tables_;
};

/// Visits the profiles of a case as visit(key, index).
template <class Visit>
void each_profile(const Case& c, const Visit& visit) {
  for (const Key& key : schema())
    if (key.bind.profiles)
      for (std::size_t i = 0; i < find_table(key.table())->count(c); ++i) visit(key, i);
}

/// "load[0].factor"; of a list with the axis, "initial.velocity, x".
std::string name_of_component(const Key& key, std::size_t index, std::size_t i) {
  return indexed_name(key.name, index) + (key.kind == Kind::profiles ? std::string(", ") + "xyz"[i] : "");
}

/// A profile at points at equal distances, at most `most` + 1 along each axis.
RecordValue samples_of(const Case& c, const Key& key, const std::string& name, const Profile& profile, int most) {
  std::array<std::vector<double>, 3> axes;
  RecordValue sample, lists(RecordValue::List{}), values(RecordValue::List{});
  for (int d = 0; d < 3; ++d) {
    const Span span = spans_of(c, key.support)[d];
    axes[d] = span.points(std::min(1.0, static_cast<double>(most) / std::max(1, span.elements)));
    lists.append(RecordValue::List(axes[d].begin(), axes[d].end()));
  }
  for (const double z : axes[2])
    for (const double y : axes[1])
      for (const double x : axes[0]) values.append(profile.at({x, y, z}));
  sample["key"] = name;
  sample["unit"] = key.unit;
  sample["axes"] = lists;
  sample["values"] = values;
  return sample;
}

}  // namespace

void build_profiles(Case& c, const Document& document, Problems& problems, Tables read) {
  const std::size_t axes = c.domain.size.size();
  if ((axes != 2 && axes != 3) || c.domain.elements.size() != axes) return;  // the checks report it
  for (const char* name : {"domain.size", "domain.elements", "substrate.thickness", "fluid.capillarity", "time.end"})
    if (problems.about(name)) return;
  ProfileBuilder builder(c, document, read);
  each_profile(c, [&](const Key& key, std::size_t index) { problems.keep([&] { builder.build(key, index); }); });
}

std::string profile_text(const Key& key) {
  const bool in_time = key.support == Support::time;
  const std::string variables =
      in_time ? "the time t of the results"
              : "the position x, y (in 3D x, y, z) in the undeformed state, the last one vertical";
  return fmt::format(
      "An expression in quotes is a function of {}. It knows the constants pi, Lx, Ly, Lz (domain.size), H "
      "(substrate.thickness), g (fluid.capillarity) and h (the largest extent of an element, where they are graded of "
      "a short one: the largest of domain.size / domain.elements), the operators + - * / ^, "
      "comparisons, && || and condition ? one : other, and the functions {}. A text that ends with .csv or .h5 is the "
      "path of a table, relative to the folder of the case: a CSV file has the columns {} and value and a line for "
      "each point of a "
      "rectangular grid, an HDF5 file has a dataset of each name. Between its points a table is linear, outside of "
      "the grid it keeps the value of the border{}.",
      variables, functions_of_expressions, in_time ? "t" : "x, y, z, or some of these,",
      in_time ? ", and steps end at its points. Such a table may stand in the case itself, as [[t, value], ...], and "
                "one for all axes as [[t, x, y], ...]"
              : "");
}

std::vector<ProfileRange> profile_ranges(const Case& c) {
  const char* const over[] = {"over the solid", "over the fluid", "along the wall", "while the load acts"};
  std::vector<ProfileRange> ranges;
  Case copy = c;
  each_profile(copy, [&](const Key& key, std::size_t index) {
    const std::vector<Profile*> all = key.bind.profiles(copy, index);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i]->varies())
        ranges.push_back({name_of_component(key, index, i), all[i]->least(), all[i]->most(),
                          key.table() == "needle[]" ? "from t = 0 on" : over[static_cast<int>(key.support)]});
  });
  return ranges;
}

std::string profile_samples(const Case& c) {
  const int most = c.dimension() == 2 ? 200 : 40;  // intervals along an axis
  RecordValue list(RecordValue::List{});
  Case copy = c;
  each_profile(copy, [&](const Key& key, std::size_t index) {
    const std::vector<Profile*> all = key.bind.profiles(copy, index);
    for (std::size_t i = 0; i < all.size() && key.support != Support::time; ++i)
      if (all[i]->varies()) list.append(samples_of(c, key, name_of_component(key, index, i), *all[i], most));
  });
  RecordValue root;
  root["profiles"] = list;
  return root.json() + "\n";
}

Case with_identities(const Case& c) {
  Case other = c;
  each_profile(other, [&](const Key& key, std::size_t index) {
    for (Profile* profile : key.bind.profiles(other, index))
      if (profile->varies() && !profile->formula->identity().empty()) profile->text = profile->formula->identity();
  });
  return other;
}

}  // namespace softwet
