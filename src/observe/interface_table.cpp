#include "observe/interface_table.hpp"

namespace softwet {

template <int D>
std::vector<std::string> interface_columns() {
  const std::string axis = "xyz";
  std::vector<std::string> names{"time"};
  for (int d = 0; d < D - 1; ++d) names.push_back(std::string(1, axis[d]) + "_reference");
  for (int d = 0; d < D; ++d) names.push_back(std::string("displacement_") + axis[d]);
  names.push_back("density");
  return names;
}

template <int D>
void add_interface_rows(TableFile& table, const Snapshot<D>& snapshot, double time) {
  const Layout<D>& layout = snapshot.layout();
  typename Snapshot<D>::Grid wall;
  for (int d = 0; d < D - 1; ++d)
    for (int i = 0; i <= 2 * layout.axis[d].elements(); ++i)
      wall[d].push_back(layout.axis[d].length() * i / (2.0 * layout.axis[d].elements()));
  wall[D - 1] = {snapshot.wall_height()};
  std::array<std::vector<double>, D> displacement;
  for (int d = 0; d < D; ++d) displacement[d] = snapshot.displacement(wall, d, false);
  std::vector<double> density;
  if (layout.has_fluid) density = snapshot.density(wall);
  for (std::size_t i = 0; i < displacement[0].size(); ++i) {
    std::vector<std::optional<double>> row{time};
    std::size_t rest = i;
    for (int d = 0; d < D - 1; ++d) {
      row.push_back(wall[d][rest % wall[d].size()]);
      rest /= wall[d].size();
    }
    for (int d = 0; d < D; ++d) row.push_back(displacement[d][i]);
    row.push_back(layout.has_fluid ? std::optional<double>(density[i]) : std::nullopt);
    table.row(row);
  }
}

template std::vector<std::string> interface_columns<2>();
template std::vector<std::string> interface_columns<3>();
template void add_interface_rows<2>(TableFile&, const Snapshot<2>&, double);
template void add_interface_rows<3>(TableFile&, const Snapshot<3>&, double);

}  // namespace softwet
