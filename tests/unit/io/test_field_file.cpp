// Field files: the layout VTKHDF 1.0 asks for, the node order of VTK, no value that is not finite, the series of times.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "expect_error.hpp"
#include "io/field_file.hpp"
#include "io/hdf5_file.hpp"
#include "io/quadratic_cells.hpp"
#include "scratch_folder.hpp"

namespace softwet {
namespace {

using Shape = std::vector<std::size_t>;

const FieldOrigin origin{"droplet", "1.2.3", "abc123"};

/// Points of the grid at their numbers (i, j, k). @return shape (points, dimension)
std::vector<double> lattice(const TensorGrid& grid) {
  std::vector<double> points;
  for (int k = 0; k <= (grid.dimension == 3 ? 2 * grid.cells[2] : 0); ++k) {
    for (int j = 0; j <= 2 * grid.cells[1]; ++j) {
      for (int i = 0; i <= 2 * grid.cells[0]; ++i) {
        points.insert(points.end(), {double(i), double(j)});
        if (grid.dimension == 3) points.push_back(k);
      }
    }
  }
  return points;
}

TEST(FieldFile, LayoutOfAPlane) {
  const ScratchFolder folder;
  const std::string path = folder / "fields/fluid_000123.hdf";
  const TensorGrid grid = {2, {3, 2, 1}};
  const std::vector<double> points = lattice(grid);
  const std::vector<double> density(35, 0.25);
  write_fields(path, origin, grid, points, {{"density", 1, density, "b"}, {"velocity", 2, points, "sqrt(ab)"}}, 1.5);
  EXPECT_FALSE(std::filesystem::exists(path + ".partial"));
  const Hdf5File file = Hdf5File::open(path, "rewrite it");
  EXPECT_EQ(file.read_text("/VTKHDF", "Type"), "UnstructuredGrid");
  EXPECT_EQ(file.shape("/VTKHDF/Points"), (Shape{35, 3}));
  EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/NumberOfPoints"), std::vector<std::int64_t>{35});
  EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/NumberOfCells"), std::vector<std::int64_t>{6});
  EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/NumberOfConnectivityIds"), std::vector<std::int64_t>{54});
  EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/Offsets"), (std::vector<std::int64_t>{0, 9, 18, 27, 36, 45, 54}));
  EXPECT_EQ(file.read<std::uint8_t>("/VTKHDF/Types"), std::vector<std::uint8_t>(6, 28));
  EXPECT_EQ(file.read<double>("/VTKHDF/PointData/density"), density);
  EXPECT_EQ(file.shape("/VTKHDF/PointData/velocity"), (Shape{35, 3}));
  EXPECT_EQ(file.read<double>("/VTKHDF/PointData/velocity"), file.read<double>("/VTKHDF/Points"));
  EXPECT_EQ(file.read<double>("/VTKHDF/FieldData/TimeValue"), std::vector<double>{1.5});
}

TEST(FieldFile, SaysWhoseFieldsItHoldsAndInWhichUnits) {
  const ScratchFolder folder;
  const std::string path = folder / "solid_0000.hdf";
  const TensorGrid grid = {2, {1, 1, 1}};
  const std::vector<double> points = lattice(grid), stress(81, 0.5), ratio(9, 1.0);
  write_fields(path, origin, grid, points, {{"stress", 9, stress, "a b^2"}, {"ratio", 1, ratio}}, 2.5);
  const Hdf5File file = Hdf5File::open(path, "rewrite it");
  EXPECT_EQ(file.read_text("/", "case"), "droplet");
  EXPECT_EQ(file.read_text("/", "version"), "1.2.3");
  EXPECT_EQ(file.read_text("/", "commit"), "abc123");
  EXPECT_EQ(file.read_double("/", "time"), 2.5);
  EXPECT_EQ(file.read_text("/", "unit_length"), "L0");
  EXPECT_EQ(file.read_text("/", "unit_time"), "L0/sqrt(ab)");
  EXPECT_EQ(file.read_text("/VTKHDF/Points", "unit"), "L0");
  EXPECT_EQ(file.read_text("/VTKHDF/FieldData/TimeValue", "unit"), "L0/sqrt(ab)");
  EXPECT_EQ(file.read_text("/VTKHDF/PointData/stress", "unit"), "a b^2");
  EXPECT_EQ(file.read_text("/VTKHDF/PointData/ratio", "unit"), "1");
  EXPECT_EQ(file.shape("/VTKHDF/PointData/stress"), (Shape{9, 9}));
}

TEST(FieldFile, LayoutOfAVolume) {
  const ScratchFolder folder;
  const std::string path = folder / "solid_000000.hdf";
  const TensorGrid grid = {3, {2, 1, 2}};
  const std::vector<double> points = lattice(grid);
  write_fields(path, origin, grid, points, {{"displacement", 3, points}}, 0);
  const Hdf5File file = Hdf5File::open(path, "rewrite it");
  EXPECT_EQ(file.read<double>("/VTKHDF/Points"), points);
  EXPECT_EQ(file.shape("/VTKHDF/Connectivity"), (Shape{4 * 27}));
  EXPECT_EQ(file.read<std::uint8_t>("/VTKHDF/Types"), std::vector<std::uint8_t>(4, 29));
}

TEST(QuadraticCells, NodesOfTheLastQuad) {
  const TensorGrid grid = {2, {2, 2, 1}};  // points 5 x 5; the last cell covers points 2..4 of both axes
  const std::vector<std::int64_t> nodes = cell_nodes(grid);
  const std::vector<std::int64_t> last(nodes.end() - 9, nodes.end());
  EXPECT_EQ(last, (std::vector<std::int64_t>{12, 14, 24, 22, 13, 19, 23, 17, 18}));
}

/// Cells on both sides of a joint have no point in common, and all points are used.
TEST(QuadraticCells, DoNotShareThePointsOfAJoint) {
  for (const int dimension : {2, 3}) {
    TensorGrid grid{dimension, {2, 3, 3}};
    grid.rows_below_joint = 1;
    const std::int64_t layer = dimension == 2 ? 5 : 5 * 7, cells_below = dimension == 2 ? 2 : 6;
    EXPECT_EQ(point_count(grid), 8 * layer);
    const std::vector<std::int64_t> nodes = cell_nodes(grid);
    const std::size_t per_cell = dimension == 2 ? 9 : 27;
    std::set<std::int64_t> below, above;
    for (std::size_t i = 0; i < nodes.size(); ++i) (i < cells_below * per_cell ? below : above).insert(nodes[i]);
    EXPECT_EQ(below.size(), 3U * layer);
    EXPECT_EQ(above.size(), 5U * layer);
    EXPECT_EQ(*below.rbegin(), 3 * layer - 1);
    EXPECT_EQ(*above.begin(), 3 * layer);
    EXPECT_EQ(*above.rbegin(), 8 * layer - 1);
  }
}

TEST(QuadraticCells, NodesOfAHexahedronLieWhereVtkWantsThem) {
  const TensorGrid grid = {3, {1, 1, 1}};
  const std::vector<double> points = lattice(grid);
  const std::vector<std::int64_t> nodes = cell_nodes(grid);
  const auto middle_of = [&](std::vector<int> corners) {
    std::vector<double> middle(3, 0.0);
    for (const int corner : corners) {
      for (int axis = 0; axis < 3; ++axis) middle[axis] += points[3 * nodes[corner] + axis] / double(corners.size());
    }
    return middle;
  };
  // Edges and faces of vtkTriQuadraticHexahedron by their corners, nodes 8 to 26.
  const std::vector<std::vector<int>> middles = {{0, 1},
                                                 {1, 2},
                                                 {2, 3},
                                                 {3, 0},
                                                 {4, 5},
                                                 {5, 6},
                                                 {6, 7},
                                                 {7, 4},
                                                 {0, 4},
                                                 {1, 5},
                                                 {2, 6},
                                                 {3, 7},
                                                 {0, 4, 7, 3},
                                                 {1, 2, 6, 5},
                                                 {0, 1, 5, 4},
                                                 {3, 7, 6, 2},
                                                 {0, 3, 2, 1},
                                                 {4, 5, 6, 7},
                                                 {0, 1, 2, 3, 4, 5, 6, 7}};
  for (std::size_t i = 0; i < middles.size(); ++i) {
    const double* point = &points[3 * nodes[8 + i]];
    EXPECT_EQ(std::vector<double>(point, point + 3), middle_of(middles[i])) << "node " << 8 + i;
  }
}

TEST(FieldFile, RefusesValuesThatAreNotFinite) {
  const ScratchFolder folder;
  const std::string path = folder / "fluid_000001.hdf";
  const TensorGrid grid = {2, {1, 1, 1}};
  std::vector<double> points = lattice(grid);
  std::vector<double> velocity(18, 0.0);
  velocity[11] = NAN;  // point 5 is (2, 1)
  expect_error(Exit::computation_failed, {path, "'velocity'", "component 1", "nan", "point 5 (2, 1)"}, [&] {
    write_fields(path, origin, grid, points, {{"velocity", 2, velocity}}, 0);
  });
  expect_error(Exit::computation_failed, {path, "time", "inf"},
               [&] { write_fields(path, origin, grid, points, {}, INFINITY); });
  points[3] = -INFINITY;
  expect_error(Exit::computation_failed, {path, "'points'", "-inf", "point 1 "},
               [&] { write_fields(path, origin, grid, points, {}, 0); });
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(FieldFile, RefusesFieldsThatDoNotFit) {
  const ScratchFolder folder;
  const std::string path = folder / "fluid_000001.hdf";
  const TensorGrid grid = {2, {1, 1, 1}};
  const std::vector<double> points = lattice(grid);
  const std::vector<double> nine(9, 1.0);
  expect_error(Exit::computation_failed, {"'density'", "8 values", "9"}, [&] {
    write_fields(path, origin, grid, points, {{"density", 1, std::vector<double>(8, 1.0)}}, 0);
  });
  expect_error(Exit::computation_failed, {"'a/b'"}, [&] {
    write_fields(path, origin, grid, points, {{"a/b", 1, nine}}, 0);
  });
  expect_error(Exit::computation_failed, {"'a'", "taken"}, [&] {
    write_fields(path, origin, grid, points, {{"a", 1, nine}, {"a", 1, nine}}, 0);
  });
}

TEST(FieldSeries, ListsFilesAndTimes) {
  const ScratchFolder folder;
  const std::string path = folder / "fields/fluid.hdf.series";
  write_series(path, {{"fluid_000000.hdf", 0.0}, {"fluid_000123.hdf", 235.5}});
  EXPECT_EQ(content_of(path),
            "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n"
            "    {\"name\": \"fluid_000000.hdf\", \"time\": 0},\n"
            "    {\"name\": \"fluid_000123.hdf\", \"time\": 235.5}\n  ]\n}\n");
}

/// Whether an object of a file shows when it was written.
bool tells_time(const Hdf5File& file, const std::string& name) {
#if H5_VERSION_GE(1, 12, 0)
  H5O_info1_t info;
#else
  H5O_info_t info;
#endif
  EXPECT_GE(H5Oget_info_by_name2(file.id(), name.c_str(), &info, H5O_INFO_TIME, H5P_DEFAULT), 0) << name;
  return info.atime != 0 || info.mtime != 0 || info.ctime != 0 || info.btime != 0;
}

TEST(FieldFile, NothingShowsWhenAFileWasWritten) {
  const ScratchFolder folder;
  for (const Hdf5Format format : {Hdf5Format::compatible, Hdf5Format::checksummed}) {
    Hdf5File file = Hdf5File::create(folder / "file", format);
    file.make_group("/one/two");
    file.write("/one/values", std::vector<double>{1, 2}, {2}, Hdf5Storage::checksummed);
    file.write("/three/four/values", std::vector<double>{1, 2}, {2});
    file.write_attribute("/one", "text", std::string("t"));
    for (const char* name : {"/", "/one", "/one/two", "/one/values", "/three", "/three/four", "/three/four/values"})
      EXPECT_FALSE(tells_time(file, name)) << name;
    file.close();
  }
}

}  // namespace
}  // namespace softwet
