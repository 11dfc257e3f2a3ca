#include "observe/output_fields.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "observe/field_values.hpp"
#include "observe/host/field_table.hpp"

namespace softwet {
namespace {

/// Reference coordinates of the points of the elements [first, last): ends and middle of each element.
std::vector<double> element_points(const Axis& axis, int first, int last) {
  std::vector<double> x;
  for (int i = 2 * first; i <= 2 * last; ++i) x.push_back(axis.end_or_middle(i));
  return x;
}

/// The elements along each axis: the rows along the vertical one, all along the others.
template <int D>
std::array<ElementRows, D> box_of(const Layout<D>& layout, ElementRows rows) {
  std::array<ElementRows, D> box;
  for (int d = 0; d < D; ++d) box[d] = {0, layout.axis[d].elements()};
  box[D - 1] = rows;
  return box;
}

template <int D>
TensorGrid cells_of(const Layout<D>& layout, ElementRows rows) {
  TensorGrid cells;
  cells.dimension = D;
  const std::array<ElementRows, D> box = box_of(layout, rows);
  for (int d = 0; d < D; ++d) {
    const Axis& axis = layout.axis[d];
    const auto [first, last] = box[d];
    cells.cells[d] = last - first;
    for (int e = first; axis.graded() && e <= last; ++e) cells.ends[d].push_back(axis.end_or_middle(2 * e));
  }
  return cells;
}

template <int D>
typename Snapshot<D>::Grid points_of(const Layout<D>& layout, ElementRows rows) {
  typename Snapshot<D>::Grid grid;
  const std::array<ElementRows, D> box = box_of(layout, rows);
  for (int d = 0; d < D; ++d) grid[d] = element_points(layout.axis[d], box[d].first, box[d].last);
  return grid;
}

/// Reference positions plus displacement.
template <int D>
std::vector<double> positions(const typename Snapshot<D>::Grid& grid, std::vector<double> displacement) {
  for (std::size_t i = 0; i < displacement.size() / D; ++i) {
    std::size_t rest = i;
    for (int d = 0; d < D; ++d) {
      displacement[D * i + d] += grid[d][rest % grid[d].size()];
      rest /= grid[d].size();
    }
  }
  return displacement;
}

/// The fields of one material that were asked for. @param names  of fields; empty: all. @param fields  gain the values
/// of a part
template <int D>
void add_selected_fields(FieldValues<D>& values, bool in_fluid, const std::vector<std::string>& names,
                         std::vector<PointField>& fields) {
  std::size_t number = 0;
  for (const FieldInfo& field : field_table()) {
    if (!(in_fluid ? field.in_fluid : field.in_solid)) continue;
    if (!names.empty() && std::find(names.begin(), names.end(), field.name) == names.end()) continue;
    const int components = field.shape == FieldShape::scalar ? 1 : field.shape == FieldShape::vector ? D : 9;
    if (number == fields.size()) fields.push_back({field.name, components, {}, field.unit});
    append(values.of(field.name), fields[number++].values);
  }
}

void write_list(const std::string& folder, const std::string& part, const std::vector<double>& times) {
  std::vector<std::pair<std::string, double>> list;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (const std::string name = field_file_name(part, i);
        std::filesystem::exists(folder + name))  // a user may remove some
      list.emplace_back(name, times[i]);
  write_series(folder + part + ".hdf.series", list);
}

}  // namespace

template <int D>
void write_field_files(const std::string& output, const FieldOrigin& origin, const std::vector<std::string>& selected,
                       const Case& c, const Coefficients<D>& coefficients, const Snapshot<D>& s,
                       const std::vector<double>& times) {
  const Layout<D>& layout = s.layout();
  const std::string folder = output + "/fields/";
  for (const std::string part : {"fluid", "solid"}) {
    const bool in_fluid = part == "fluid";
    if (in_fluid ? !layout.has_fluid : !layout.has_solid) continue;
    TensorGrid cells = cells_of(layout, in_fluid ? s.fluid_rows() : s.solid_rows());
    if (!in_fluid) cells.rows_below_joint = layout.axis[D - 1].joint();
    std::vector<double> points;
    std::vector<PointField> fields;
    for (const ElementRows rows : in_fluid ? std::vector{s.fluid_rows()} : s.solid_parts()) {
      const typename Snapshot<D>::Grid grid = points_of(layout, rows);
      FieldValues<D> values(c, coefficients, s, grid, rows);
      append(positions<D>(grid, values.of("displacement")), points);
      add_selected_fields(values, in_fluid, selected, fields);
    }
    write_fields(folder + field_file_name(part, times.size() - 1), origin, cells, points, fields, times.back());
    write_list(folder, part, times);
  }
}

template void write_field_files(const std::string&, const FieldOrigin&, const std::vector<std::string>&, const Case&,
                                const Coefficients<2>&, const Snapshot<2>&, const std::vector<double>&);
template void write_field_files(const std::string&, const FieldOrigin&, const std::vector<std::string>&, const Case&,
                                const Coefficients<3>&, const Snapshot<3>&, const std::vector<double>&);

}  // namespace softwet
