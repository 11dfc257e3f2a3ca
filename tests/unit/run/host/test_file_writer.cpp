// The order of tasks and steps, and what becomes of errors.
#include "run/host/file_writer.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace softwet::testing_tools {
namespace {

const auto no_work = [] {};

/// Holds a task until it is opened.
class Gate {
 public:
  void open() { promise_.set_value(); }
  void pass() const { future_.wait(); }

 private:
  std::promise<void> promise_;
  std::shared_future<void> future_ = promise_.get_future().share();
};

TEST(FileWriter, InTurnATaskIsDoneWhenItHasStarted) {
  FileWriter writer(Writes::in_turn, [] { FAIL() << "no thread starts"; });
  std::thread::id by;
  writer.start([&] { by = std::this_thread::get_id(); });
  EXPECT_EQ(by, std::this_thread::get_id());
  EXPECT_THROW(writer.start([] { throw std::runtime_error("full"); }), std::runtime_error);
  EXPECT_EQ(writer.wait(), 0);
}

TEST(FileWriter, StepsGoOnBesideATask) {
  FileWriter writer(Writes::beside_steps);
  Gate gate;
  std::atomic<bool> written = false;
  writer.start([&] {
    gate.pass();  // for ever, if this thread had to wait for the task
    written = true;
  });
  EXPECT_FALSE(written);
  gate.open();
  EXPECT_GE(writer.wait(), 0);
  EXPECT_TRUE(written);
}

TEST(FileWriter, TasksRunOneAfterTheOther) {
  FileWriter writer(Writes::beside_steps);
  std::vector<int> order;  // no lock: a sanitizer of threads would see two tasks at once
  for (int i = 0; i < 50; ++i) writer.start([&order, i] { order.push_back(i); });
  writer.wait();
  ASSERT_EQ(order.size(), 50U);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(order[i], i);
}

TEST(FileWriter, WhatATaskThrowsIsThrownOnce) {
  FileWriter writer(Writes::beside_steps);
  std::string told;
  writer.start([] { throw std::runtime_error("disk full"); });
  try {
    writer.wait();
  } catch (const std::runtime_error& error) {
    told = error.what();
  }
  EXPECT_EQ(told, "disk full");
  EXPECT_NO_THROW(writer.wait());
  bool next = false;
  writer.start([] { throw std::runtime_error("disk full"); });
  EXPECT_THROW(writer.start([&] { next = true; }), std::runtime_error);  // before the next task
  EXPECT_FALSE(next);
  writer.start([&] { next = true; });
  writer.wait();
  EXPECT_TRUE(next);
}

TEST(FileWriter, ItsEndWaitsForTheTask) {
  std::atomic<bool> written = false;
  Gate gate;
  std::optional<FileWriter> writer(std::in_place, Writes::beside_steps);
  writer->start([&] {
    gate.pass();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    written = true;
  });
  gate.open();
  writer.reset();
  EXPECT_TRUE(written);
  writer.emplace(Writes::beside_steps);
  writer->start([] { throw std::runtime_error("nobody hears of it"); });
  EXPECT_NO_THROW(writer.reset());
}

TEST(FileWriter, EntersEachThread) {
  std::vector<std::thread::id> entered;
  FileWriter writer(Writes::beside_steps, [&] { entered.push_back(std::this_thread::get_id()); });
  writer.start(no_work);
  writer.start(no_work);
  writer.wait();
  ASSERT_EQ(entered.size(), 2U);
  for (const std::thread::id& thread : entered) EXPECT_NE(thread, std::this_thread::get_id());
}

/// Written data live until their task has ended, and no longer than until somebody has waited for it.
TEST(FileWriter, ATaskOwnsWhatItWrites) {
  const auto values = std::make_shared<std::vector<double>>(3, 1.0);
  FileWriter writer(Writes::beside_steps);
  writer.start([values] { EXPECT_EQ(values->size(), 3U); });
  writer.wait();
  EXPECT_EQ(values.use_count(), 1);
}

}  // namespace
}  // namespace softwet::testing_tools
