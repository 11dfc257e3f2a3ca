#include "observe/output_fields.hpp"

#include <algorithm>
#include <filesystem>

#include "observe/host/field_table.hpp"

namespace softwet {
namespace {

/// Reference coordinates of the points of the elements [first, last): ends and middle of each element.
std::vector<double> element_points(const Axis& axis, int first, int last) {
  std::vector<double> x;
  for (int i = 2 * first; i <= 2 * last; ++i) x.push_back(axis.end_or_middle(i));
  return x;
}

/// The elements of one material.
template <int D>
struct Block {
  TensorGrid cells;
  typename Snapshot<D>::Grid grid;

  Block(const Layout<D>& layout, int first, int last) {
    cells.dimension = D;
    for (int d = 0; d < D; ++d) {
      const Axis& axis = layout.axis[d];
      const int low = d == D - 1 ? first : 0, high = d == D - 1 ? last : axis.elements();
      cells.cells[d] = high - low;
      grid[d] = element_points(axis, low, high);
      for (int e = low; axis.graded() && e <= high; ++e) cells.ends[d].push_back(axis.end_or_middle(2 * e));
    }
  }
};

/// D components, one after the other, to components fastest.
template <int D>
std::vector<double> interleave(const std::array<std::vector<double>, D>& component) {
  std::vector<double> values(D * component[0].size());
  for (int d = 0; d < D; ++d)
    for (std::size_t i = 0; i < component[d].size(); ++i) values[D * i + d] = component[d][i];
  return values;
}

template <int D>
std::vector<double> vector_field(const typename Snapshot<D>::Grid& grid, const auto& component) {
  std::array<std::vector<double>, D> all;
  for (int d = 0; d < D; ++d) all[d] = component(grid, d);
  return interleave<D>(all);
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

/// Grad u of the solid at the points of a grid. In 2D the third row and column are 0, plane strain, but in the coordinates (r, z)
/// for u_r / r, which is du_r/dr at the axis.
template <int D>
std::vector<Matrix<double, 3>> displacement_gradients(const Snapshot<D>& s, const typename Snapshot<D>::Grid& grid) {
  std::vector<Matrix<double, 3>> gradients;
  for (int d = 0; d < D; ++d)
    for (int axis = 0; axis < D; ++axis) {
      const std::vector<double> slope = s.displacement_gradient(grid, d, axis);
      gradients.resize(slope.size(), Matrix<double, 3>{});
      for (std::size_t i = 0; i < slope.size(); ++i) gradients[i](d, axis) = slope[i];
    }
  if (!s.layout().axisymmetric) return gradients;
  const std::vector<double> radial = s.displacement(grid, 0, false);
  for (std::size_t i = 0; i < radial.size(); ++i) {
    const double r = grid[0][i % grid[0].size()];
    gradients[i](2, 2) = r > 0 ? radial[i] / r : gradients[i](0, 0);
  }
  return gradients;
}

/// A tensor of each gradient, row by row: 9 numbers a point.
std::vector<double> tensors(const std::vector<Matrix<double, 3>>& gradients, const auto& law) {
  std::vector<double> values;
  values.reserve(9 * gradients.size());
  for (const Matrix<double, 3>& gradient : gradients) {
    const Matrix<double, 3> tensor = law(gradient);
    for (int i = 0; i < 3; ++i) values.insert(values.end(), tensor.c[i], tensor.c[i] + 3);
  }
  return values;
}

/// The fields of one file: those that were asked for, evaluated.
class Selection {
 public:
  /// @param names  those wanted; empty: all
  Selection(int dimension, const std::vector<std::string>& names) : dimension_(dimension), names_(names) {}

  void add(const std::string& name, const auto& evaluate) {
    if (!names_.empty() && std::find(names_.begin(), names_.end(), name) == names_.end()) return;
    const FieldInfo& info = field_info(name);
    const int components = info.shape == FieldShape::scalar ? 1 : info.shape == FieldShape::vector ? dimension_ : 9;
    fields_.push_back({name, components, evaluate(), info.unit});
  }
  const std::vector<PointField>& fields() const { return fields_; }

 private:
  int dimension_;
  const std::vector<std::string>& names_;
  std::vector<PointField> fields_;
};

template <int D, int P>
void add_fluid_fields(Selection& selection, const Model<D, P>& model, const Snapshot<D>& s,
                      const typename Snapshot<D>::Grid& grid) {
  selection.add("velocity",
                [&] { return vector_field<D>(grid, [&](const auto& at, int d) { return s.velocity(at, d, true); }); });
  selection.add("density", [&] { return s.density(grid); });
  selection.add("chemical_potential", [&] { return s.chemical_potential(grid); });
  selection.add("pressure", [&] {
    std::vector<double> pressure;
    for (double rho : s.density(grid)) pressure.push_back(model.fluid().gas.pressure(rho));
    return pressure;
  });
}

template <int D, int P>
void add_solid_fields(Selection& selection, const Model<D, P>& model, const Snapshot<D>& s,
                      const typename Snapshot<D>::Grid& grid, const std::vector<double>& displacement) {
  using Gradient = Matrix<double, 3>;
  const std::vector<Gradient> gradients = displacement_gradients(s, grid);
  selection.add("velocity",
                [&] { return vector_field<D>(grid, [&](const auto& at, int d) { return s.velocity(at, d, false); }); });
  selection.add("displacement", [&] { return displacement; });
  selection.add("green_lagrange_strain",
                [&] { return tensors(gradients, [](const Gradient& g) { return green_lagrange_strain(g); }); });
  const auto stress = [&](const auto& of_material) {
    return std::visit(
        [&](const auto& solid) {
          return tensors(gradients, [&](const Gradient& g) { return of_material(solid.material, g); });
        },
        model.solid());
  };
  selection.add("first_piola_stress",
                [&] { return stress([](const auto& m, const Gradient& g) { return m.first_piola(g); }); });
  selection.add("cauchy_stress",
                [&] { return stress([](const auto& m, const Gradient& g) { return cauchy_stress(m, g); }); });
  selection.add("volume_ratio", [&] {
    std::vector<double> ratio;
    for (const Gradient& g : gradients) ratio.push_back(volume_ratio(g));
    return ratio;
  });
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

template <int D, int P>
void write_field_files(const std::string& output, const FieldOrigin& origin, const std::vector<std::string>& selected,
                       const Model<D, P>& model, const Snapshot<D>& s, const std::vector<double>& times) {
  const Layout<D>& layout = model.layout();
  const std::string folder = output + "/fields/";
  for (const std::string part : {"fluid", "solid"}) {
    const bool in_fluid = part == "fluid";
    if (in_fluid ? !layout.has_fluid : !layout.has_solid) continue;
    const int wall = layout.solid_elements;
    const Block<D> block(layout, in_fluid ? wall : 0, in_fluid ? layout.axis[D - 1].elements() : wall);
    const auto& grid = block.grid;
    const std::vector<double> displacement =
        vector_field<D>(grid, [&](const auto& points, int d) { return s.displacement(points, d, in_fluid); });
    Selection selection(D, selected);
    in_fluid ? add_fluid_fields(selection, model, s, grid) : add_solid_fields(selection, model, s, grid, displacement);
    write_fields(folder + field_file_name(part, times.size() - 1), origin, block.cells,
                 positions<D>(grid, displacement), selection.fields(), times.back());
    write_list(folder, part, times);
  }
}

template void write_field_files(const std::string&, const FieldOrigin&, const std::vector<std::string>&,
                                const Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>&, const Snapshot<SOFTWET_DIMENSION>&,
                                const std::vector<double>&);

}  // namespace softwet
