// The numbers of OMRON programs, which their files' names give.

#include <gtest/gtest.h>

#include "dialect/omron/compile.hpp"

namespace kerf::omron {
namespace {

// OMR-054: a main program may have any number, also one of a subprogram.
TEST(OmronPrograms, AMainProgramMayHaveAnyNumber) {
  EXPECT_EQ(number_in_name("1.nc"), 1);
  EXPECT_EQ(number_in_name("999.nc"), 999);
  EXPECT_EQ(number_in_name("P1000.nc"), 1000);
  EXPECT_EQ(number_in_name("folder.7/P9999.nc"), 9999);
  EXPECT_EQ(number_in_name("part12.nc"), 12);
}

// A name without a number at its end.
TEST(OmronPrograms, AProgramWithoutANumberIsTheFirst) {
  EXPECT_EQ(number_in_name("part.nc"), 1);
  EXPECT_EQ(number_in_name("12a.nc"), 1);
  EXPECT_EQ(number_in_name(""), 1);
}

}  // namespace
}  // namespace kerf::omron
