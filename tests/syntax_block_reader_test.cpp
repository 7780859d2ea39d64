#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "syntax/block_reader.hpp"

namespace kerf {
namespace {

BlockReader reader_of(std::string_view text) {
  return BlockReader(Source::from_text("test", text));
}

/// All blocks as "address+digits/decimals" words, or the fault that ended the reading.
struct Reading {
  std::vector<std::string> blocks;
  std::vector<std::uint32_t> lines;
  SyntaxFault fault = SyntaxFault::none;
  SourceSpan place;
  bool closed = false;
};

Reading read_all(std::string_view text, bool skip = false) {
  BlockReader reader = reader_of(text);
  Reading reading;
  Block block;
  for (;;) {
    const auto result = reader.next(block, skip);
    if (result == BlockReader::Result::end) break;
    if (result == BlockReader::Result::fault) {
      reading.fault = reader.fault();
      reading.place = reader.fault_span();
      break;
    }
    std::string words;
    for (const Word& word : block.words) {
      words += fmt::format("{}{}{}{} ", word.address, word.number.digits, word.number.has_point ? "." : "",
                           word.number.has_point ? std::to_string(word.number.decimals) : "");
    }
    reading.blocks.push_back(words);
    reading.lines.push_back(block.span.line);
  }
  reading.closed = reader.closed();
  return reading;
}

TEST(BlockReader, ReadsWordsWithSignsPointsAndBlanks) {
  const Reading reading = read_all("%\nG01 X-12.50Y+3 Z .5\tF600.\n%\n");
  ASSERT_EQ(reading.blocks.size(), 1U);
  EXPECT_EQ(reading.blocks[0], "G1 X-1250.2 Y3 Z5.1 F600.0 ");
  EXPECT_EQ(reading.lines[0], 2U);
  EXPECT_TRUE(reading.closed);
}

TEST(BlockReader, KeepsPlacesOfWords) {
  BlockReader reader = reader_of("%\n  G00 X1.0\n");
  Block block;
  ASSERT_EQ(reader.next(block, false), BlockReader::Result::block);
  const SourceSpan x = span_of(block, block.words[1]);
  EXPECT_EQ(x.line, 2U);
  EXPECT_EQ(x.column, 7U);
  EXPECT_EQ(x.length, 4U);
  EXPECT_EQ(x.offset, 8U);
}

TEST(BlockReader, LowerCaseIsUpperCase) {
  EXPECT_EQ(read_all("%\ng1x2\n").blocks, read_all("%\nG1X2\n").blocks);
}

TEST(BlockReader, LineEndsLfAndCrLfAreTheSame) {
  EXPECT_EQ(read_all("%\r\nG1\r\nX2\r\n%\r\n").blocks, read_all("%\nG1\nX2\n%\n").blocks);
}

TEST(BlockReader, CarriageReturnAloneIsAFault) {
  const Reading reading = read_all("%\nG1\rX2\n");
  EXPECT_EQ(reading.fault, SyntaxFault::line_end);
  EXPECT_EQ(reading.place.column, 3U);
  EXPECT_EQ(read_all("%\rG1\rX2\r").fault, SyntaxFault::line_end);
}

TEST(BlockReader, LeaderAndTrailerAreIgnored) {
  const Reading reading = read_all("\xEF\xBB\xBFhello \x01 world\n%\nG1\n%\nG2 rubbish \x02\n");
  EXPECT_EQ(reading.fault, SyntaxFault::none);
  EXPECT_EQ(reading.blocks.size(), 1U);
}

TEST(BlockReader, ByteOrderMarkBeforeTheDataStart) {
  EXPECT_EQ(read_all("\xEF\xBB\xBF%\nG1\n").blocks.size(), 1U);
}

TEST(BlockReader, DataStartIsNeeded) {
  EXPECT_EQ(read_all("G1\nM02\n").fault, SyntaxFault::no_data_start);
  EXPECT_EQ(read_all("G1\nM02\n%\n").fault, SyntaxFault::no_data_start);
  EXPECT_EQ(read_all("").fault, SyntaxFault::no_data_start);
  EXPECT_EQ(read_all("%").fault, SyntaxFault::none);
}

TEST(BlockReader, NothingBesideTheDataMark) {
  EXPECT_EQ(read_all("%G21\n").fault, SyntaxFault::data_mark);
  const Reading reading = read_all("%\nG1\n% X\n");
  EXPECT_EQ(reading.fault, SyntaxFault::data_mark);
  EXPECT_EQ(reading.place.line, 3U);
  EXPECT_EQ(reading.place.column, 3U);
}

TEST(BlockReader, CommentsEndAtTheFirstParenthesis) {
  EXPECT_EQ(read_all("%\n(a(b)G1(c)X2\n").blocks[0], "G1 X2 ");
  EXPECT_EQ(read_all("%\nG1(abc\nX2)\n").fault, SyntaxFault::comment_open);
}

TEST(BlockReader, BlockSkip) {
  EXPECT_EQ(read_all("%\n/G1\nN5/G2\n/N6G3\nX1\n", true).blocks.size(), 1U);
  EXPECT_EQ(read_all("%\n/G1\nN5/G2\n/N6G3\nX1\n", false).blocks.size(), 4U);
  EXPECT_EQ(read_all("%\nG0/X1\n").fault, SyntaxFault::block_skip);
  EXPECT_EQ(read_all("%\n//G0\n").fault, SyntaxFault::block_skip);
}

TEST(BlockReader, FaultyWords) {
  EXPECT_EQ(read_all("%\nGX1\n").fault, SyntaxFault::bad_number);
  EXPECT_EQ(read_all("%\nX-\n").fault, SyntaxFault::bad_number);
  EXPECT_EQ(read_all("%\nX.\n").fault, SyntaxFault::bad_number);
  EXPECT_EQ(read_all("%\n12\n").fault, SyntaxFault::bad_number);
  EXPECT_EQ(read_all("%\nX1,5\n").fault, SyntaxFault::bad_character);
  EXPECT_EQ(read_all(std::string_view("%\nX1\0\n", 6)).fault, SyntaxFault::bad_character);
}

TEST(BlockReader, ReadingGoesOnBehindAFault) {
  BlockReader reader = reader_of("%\nX?\nY2\n");
  Block block;
  EXPECT_EQ(reader.next(block, false), BlockReader::Result::fault);
  EXPECT_EQ(reader.next(block, false), BlockReader::Result::block);
  EXPECT_EQ(block.words[0].address, 'Y');
  EXPECT_EQ(reader.next(block, false), BlockReader::Result::end);
  EXPECT_EQ(reader.next(block, false), BlockReader::Result::end);
}

TEST(BlockReader, NumbersOfEveryLengthWithThePointAnywhere) {
  for (std::size_t length = 1; length <= 18; ++length) {
    const std::string digits = std::string("987654321012345678").substr(0, length);
    for (std::size_t point = 0; point <= length + 1; ++point) {  // the last: no point
      const bool has_point = point <= length;
      std::string number = digits;
      if (has_point) number.insert(point, ".");
      for (const std::string_view behind : {"", " ", "Y1", "\t", "\xFF"}) {
        BlockReader reader = reader_of("%\nX" + number + std::string(behind) + "\nZ2\n");
        Block block;
        const auto result = reader.next(block, false);
        EXPECT_EQ(result == BlockReader::Result::fault, behind == "\xFF");
        ASSERT_FALSE(block.words.empty());
        const Decimal& read = block.words[0].number;
        EXPECT_EQ(read.digits, std::stoll(digits)) << number;
        EXPECT_EQ(read.decimals, has_point ? length - point : 0U) << number;
        EXPECT_EQ(read.has_point, has_point) << number;
        EXPECT_EQ(block.words[0].length, number.size() + 1);
      }
    }
  }
}

TEST(BlockReader, ASecondPointIsNoPartOfTheNumber) {
  for (const char* block : {"X1.2.3", "X.1.", "X..1", "X1234567.8.9", "X12345678..9"}) {
    EXPECT_EQ(read_all(std::string("%\n") + block + "\n").fault, SyntaxFault::bad_number) << block;
  }
}

TEST(BlockReader, LongNumbers) {
  BlockReader reader =
      reader_of("%\nX0000000000000000000000012.5Y1.00000000000000000000009Z12345678901234567890\n");
  Block block;
  ASSERT_EQ(reader.next(block, false), BlockReader::Result::block);
  EXPECT_EQ(block.words[0].number.digits, 125);
  EXPECT_EQ(block.words[0].number.decimals, 1);
  EXPECT_EQ(block.words[1].number.digits, 100'000'000'000'000'000);
  EXPECT_EQ(block.words[1].number.decimals, 17);
  EXPECT_FALSE(block.words[1].number.overflow);
  EXPECT_TRUE(block.words[2].number.overflow);
}

TEST(BlockReader, TooManyWordsInABlock) {
  std::string text = "%\n";
  for (std::size_t i = 0; i < Block::kMaxWords; ++i) text += "G1";
  EXPECT_EQ(read_all(text + "\n").fault, SyntaxFault::none);
  EXPECT_EQ(read_all(text + "G1\n").fault, SyntaxFault::block_too_long);
}

TEST(BlockReader, ACopyKeepsItsPlace) {
  BlockReader reader = reader_of("%\nX1\nX2\nX3\n");
  Block block;
  reader.next(block, false);
  BlockReader copy = reader;
  reader.next(block, false);
  reader.next(block, false);
  EXPECT_EQ(block.words[0].number.digits, 3);
  copy.next(block, false);
  EXPECT_EQ(block.words[0].number.digits, 2);
}

}  // namespace
}  // namespace kerf
