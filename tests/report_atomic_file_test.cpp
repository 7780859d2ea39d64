#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <sys/stat.h>

#include "report/atomic_file.hpp"
#include "report_test_support.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;
using report_test::read_file;

/// A folder of its own for each test.
class ReportAtomicFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("kerf_atomic_file_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  int files() const {
    return static_cast<int>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator{}));
  }

  fs::path folder_;
};

TEST_F(ReportAtomicFile, WritesTheWholeFileAndNothingElse) {
  const std::string contents("a\0b\n", 4);
  ASSERT_TRUE(write_file(path("out.csv"), contents));
  EXPECT_EQ(read_file(path("out.csv")), contents);
  EXPECT_EQ(files(), 1);
}

TEST_F(ReportAtomicFile, UncommittedLeavesTheOldFileAlone) {
  ASSERT_TRUE(write_file(path("out.csv"), "old"));
  {
    auto file = AtomicFile::open(path("out.csv"));
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->write("half of the new"));
    EXPECT_EQ(read_file(path("out.csv")), "old");
    EXPECT_EQ(files(), 2);  // the old one and the temporary beside it
  }
  EXPECT_EQ(read_file(path("out.csv")), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(ReportAtomicFile, PiecesJoinAtCommit) {
  auto file = AtomicFile::open(path("out.csv"));
  ASSERT_TRUE(file);
  AtomicFile moved = std::move(*file);
  ASSERT_TRUE(moved.write("one,"));
  ASSERT_TRUE(moved.write("two"));
  EXPECT_FALSE(fs::exists(path("out.csv")));
  ASSERT_TRUE(moved.commit());
  EXPECT_EQ(read_file(path("out.csv")), "one,two");
  EXPECT_EQ(files(), 1);
}

TEST_F(ReportAtomicFile, RefusesAFolder) {
  const auto written = write_file(folder_.string(), "x");
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message.find(folder_.string()), std::string::npos);
  EXPECT_NE(written.error().message.find("directory"), std::string::npos);
  EXPECT_EQ(written.error().remedy, "name a file inside the folder");
  EXPECT_FALSE(write_file(path("new/"), "x"));
  EXPECT_EQ(files(), 0);
}

TEST_F(ReportAtomicFile, NamesCauseAndRemedyOfAMissingFolder) {
  const auto written = write_file(path("missing/out.csv"), "x");
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message.find("missing/out.csv"), std::string::npos);
  EXPECT_EQ(written.error().remedy, "create the folder first, or name one that exists");
  EXPECT_FALSE(write_file("", "x"));
  EXPECT_EQ(files(), 0);
}

// The device always says that the disk is full.
TEST_F(ReportAtomicFile, FailedWriteIsReported) {
  const auto written = write_file("/dev/full", "x");
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().remedy.find("free some space"), std::string::npos);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(ReportAtomicFile, FailedCommitLeavesNothingBehind) {
  auto file = AtomicFile::open(path("out.csv"));
  ASSERT_TRUE(file);
  ASSERT_TRUE(file->write("x"));
  fs::create_directory(path("out.csv"));  // a folder took the name meanwhile
  EXPECT_FALSE(file->commit());
  EXPECT_EQ(files(), 1);
}

TEST_F(ReportAtomicFile, KeepsPermissionsAndFollowsLinks) {
  ASSERT_TRUE(write_file(path("real.csv"), "old"));
  fs::permissions(path("real.csv"), fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  fs::create_symlink(path("real.csv"), path("link.csv"));
  ASSERT_TRUE(write_file(path("link.csv"), "new"));
  EXPECT_TRUE(fs::is_symlink(path("link.csv")));
  EXPECT_EQ(read_file(path("real.csv")), "new");
  EXPECT_EQ(fs::status(path("real.csv")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
}

TEST_F(ReportAtomicFile, DevicesAreWrittenDirectly) {
  EXPECT_TRUE(write_file("/dev/null", "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace kerf
