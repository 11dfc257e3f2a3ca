#include "observe/output_fields.hpp"

#include "observe/host/field_file.hpp"

namespace softwet {
namespace {

/// Reference coordinates of the points of the elements [first, last): ends and middle of each element.
std::vector<double> element_points(const Axis& axis, int first, int last) {
  std::vector<double> x;
  for (int i = 2 * first; i <= 2 * last; ++i) x.push_back(axis.length() * i / (2.0 * axis.elements()));
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

void write_list(const std::string& folder, const std::string& part, const std::vector<double>& times) {
  std::vector<std::pair<std::string, double>> list;
  for (std::size_t i = 0; i < times.size(); ++i) list.emplace_back(field_file_name(part, i), times[i]);
  write_series(folder + part + ".hdf.series", list);
}

}  // namespace

template <int D, int P>
void write_field_files(const std::string& output, const Model<D, P>& model, const Snapshot<D>& s,
                       const std::vector<double>& times) {
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
    std::vector<PointField> fields{
        {"velocity", D, vector_field<D>(grid, [&](const auto& at, int d) { return s.velocity(at, d, in_fluid); })}};
    if (in_fluid) {
      const std::vector<double> density = s.density(grid);
      std::vector<double> pressure;
      for (double rho : density) pressure.push_back(model.fluid().gas.pressure(rho));
      fields.push_back({"density", 1, density});
      fields.push_back({"chemical_potential", 1, s.chemical_potential(grid)});
      fields.push_back({"pressure", 1, pressure});
    } else {
      fields.push_back({"displacement", D, displacement});
    }
    write_fields(folder + field_file_name(part, times.size() - 1), block.cells, positions<D>(grid, displacement),
                 fields, times.back());
    write_list(folder, part, times);
  }
}

template void write_field_files(const std::string&, const Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>&,
                                const Snapshot<SOFTWET_DIMENSION>&, const std::vector<double>&);

}  // namespace softwet
