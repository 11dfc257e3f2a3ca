// The product with the correction of a coarse level, against its definition in double precision.
#include "solver/schwarz/coarse_image.hpp"

#include "unit/solver/random_matrix.hpp"

namespace softwet::testing_tools {
namespace {

/// Values in 16 bits leave 2^-9 of each.
constexpr double of_rounded_values = 2e-3;

/// r - A P z, in two builds. The error is the error of A P z.
template <int D>
void check_image(const Shape& shape) {
  RandomMatrix<D> random(shape);
  const CoarseSpace<D> space(random.layout, random.mask, 2);
  ASSERT_TRUE(space.exists());
  const Sparse p = prolongation(random.layout, random.mask, space, 2);
  CoarseImage<D> image(random.layout, random.mask, space);
  const Array y("y", random.layout.size());
  for (int build = 0; build < 2; ++build) {
    const DenseVector r = random.direction(), z = p.transpose() * random.direction();
    const DenseVector expected = sparse(random.matrix) * (p * z);
    image.build(random.matrix);
    image.residual(to_array(r), to_array(z), y);
    EXPECT_LT(relative(r - to_vector(y), expected), of_rounded_values);
    random.fill();
  }
}

TEST(CoarseImage, IsTheMatrixTimesTheCorrection) {
  for (const Shape& shape : shapes_3d()) check_image<3>(shape);
  for (const Shape& shape :
       {Shape{{140, 6}, 2}, {{70, 5}, 0}, {{8, 6}, 6}, {{150, 8}, 4, 3}, {{4, 8}, 0, 2, true}, {{6, 8}, 2, 3, true}})
    check_image<2>(shape);
}

/// A product reads half of the values that the matrix has.
TEST(CoarseImage, IsSmallerThanTheMatrix) {
  const RandomMatrix<3> random({{16, 8, 8}, 0});
  const CoarseSpace<3> space(random.layout, random.mask, 2);
  const CoarseImage<3> image(random.layout, random.mask, space);
  const double padded = host_algorithms ? 192.0 / 180 : 1;  // rows of 18 x 10 points are stored as 192
  EXPECT_EQ(image.bytes(), 0.5 * 64 / 125 * random.matrix.bytes() * padded);
}

}  // namespace
}  // namespace softwet::testing_tools
