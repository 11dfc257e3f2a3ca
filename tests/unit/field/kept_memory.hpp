// What a scheme remembers, kept in memory as a checkpoint keeps it on the disk.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "field/step_memory.hpp"
#include "field/vector.hpp"

namespace softwet::testing_tools {

class KeptMemory final : public StepMemory {
 public:
  /// Makes later visits put back the kept values.
  void put_back() { restores_ = true; }

  bool restores() const override { return restores_; }
  void number(const std::string& name, double& value) override { visit(numbers_, name, value); }
  void count(const std::string& name, int& value) override {
    EXPECT_GE(value, 0) << name;
    visit(counts_, name, value);
  }
  void vector(const std::string& name, const Array& values) override {
    std::vector<double> host = to_host(values);
    visit(vectors_, name, host);
    Kokkos::deep_copy(values, to_device<Array>(host));
  }
  void vector(const std::string& name, const ArrayOf<float>& values) override {
    const Array wide("wide", values.extent(0));
    convert(wide, values);
    vector(name, wide);
    convert(values, wide);
  }

 private:
  template <class Value>
  void visit(std::map<std::string, Value>& kept, const std::string& name, Value& value) {
    if (restores_)
      value = kept.at(name);
    else
      EXPECT_TRUE(kept.emplace(name, value).second) << name << " is there twice";
  }

  bool restores_ = false;
  std::map<std::string, double> numbers_;
  std::map<std::string, int> counts_;
  std::map<std::string, std::vector<double>> vectors_;
};

}  // namespace softwet::testing_tools
