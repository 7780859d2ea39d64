#pragma once
// Two ways of executing the same blocks must give the same: random programs, each as it is and with a mark in
// every block concerned that changes nothing but the way.

#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

#include "dialect/setup.hpp"
#include "transcript.hpp"

namespace kerf {

using Random = std::mt19937;

inline unsigned below(Random& random, unsigned limit) {
  return static_cast<unsigned>(random() % limit);
}

struct ProgramPair {
  std::string plain;
  std::string marked;

  void add(const std::string& text) {
    plain += text;
    marked += text;
  }
};

struct ShortWayTest {
  std::string dialect;
  std::string name;  ///< of the program's file
  unsigned programs = 150;
  unsigned fewest_actions = 20;  ///< of a program, on average
  ProgramPair (*make)(unsigned seed) = nullptr;
  ProgramTexts others = [](std::int32_t) { return ProgramText{}; };
};

inline void expect_same(const ShortWayTest& test, const std::vector<std::string>& assignments) {
  SetupOptions options;
  options.dialect = test.dialect;
  options.assignments = assignments;
  auto controller = make_controller(options);
  ASSERT_TRUE(controller.has_value());
  controller->interpreter_options.programs = test.others;
  std::size_t actions = 0;
  for (unsigned seed = 1; seed <= test.programs; ++seed) {
    const ProgramPair programs = test.make(seed);
    const auto expected = transcript(*controller, test.name, programs.marked);
    ASSERT_EQ(transcript(*controller, test.name, programs.plain), expected) << programs.plain;
    actions += expected.size();
  }
  EXPECT_GT(actions, std::size_t{test.programs} * test.fewest_actions);
}

}  // namespace kerf
