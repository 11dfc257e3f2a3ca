// What a user reads when the parallel runtime fails.
#include "machine/backend_error.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

TEST(BackendError, MissingMemoryIsAQuestionOfTheCase) {
  const Error error = backend_error("Kokkos ERROR: Cuda memory space failed to allocate 3 GiB (label=\"x\").");
  EXPECT_EQ(error.code(), Exit::machine_failed);
  EXPECT_NE(std::string(error.what()).find("3 GiB (label=\"x\").; 'softwet check CASE' shows"), std::string::npos);
}

TEST(BackendError, AKernelThatDoesNotStartIsNot) {
  const Error error = backend_error("the device does not start softwet::elements");
  EXPECT_EQ(error.code(), Exit::machine_failed);
  EXPECT_EQ(std::string(error.what()).find("softwet check"), std::string::npos);
  EXPECT_NE(std::string(error.what()).find("softwet::elements"), std::string::npos);
  EXPECT_NE(std::string(error.what()).find("softwet info"), std::string::npos);
}

}  // namespace
}  // namespace softwet
