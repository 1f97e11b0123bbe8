#include "apps/input/delimited_file.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/input/cells.hpp"
#include "tests/apps/input/written_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace swirl::apps;
using swirl::tests::WrittenFile;
using testing::HasSubstr;
using Columns = std::vector<std::vector<double>>;
using Words = std::vector<std::string>;

std::string refusal(const std::function<void()>& action) {
    try {
        action();
    } catch (const BadInput& error) {
        return error.what();
    }
    return "nothing was refused";
}

Columns all_columns(const DelimitedFile& file) {
    std::vector<std::size_t> wanted;
    for (std::size_t k = 0; k < file.columns; ++k) wanted.push_back(k);
    return numbers_of(file, wanted, std::vector<bool>(file.columns, true));
}

TEST(DelimitedFile, EverySeparatorGivesTheSameNumbers) {
    for (const std::string separator : {",", ";", "\t", " ", "   ", " , ", "; "}) {
        const WrittenFile file("1" + separator + "-2.5e-1\n3" + separator + "+4\n");
        const auto read = read_delimited(file.path());
        EXPECT_EQ(all_columns(read), (Columns{{1, 3}, {-0.25, 4}})) << "separator '" << separator << "'";
        EXPECT_TRUE(read.header.empty());
    }
}

TEST(DelimitedFile, LineEndsCommentsBlankLinesAndAMarkAreNoData) {
    for (const std::string end : {"\n", "\r\n"}) {
        const WrittenFile file("\xEF\xBB\xBF# camera 3" + end + end + "t,S" + end + "  % note" + end + "0,1" + end +
                               "1,2");
        const auto read = read_delimited(file.path());
        EXPECT_EQ(read.header, (Words{"t", "S"}));
        EXPECT_EQ(all_columns(read), (Columns{{0, 1}, {1, 2}}));
        EXPECT_EQ(read.rows.front().line, 5u);
    }
}

TEST(DelimitedFile, QuotesHoldSeparatorsBlanksAndQuotes) {
    EXPECT_EQ(cells_of(R"("a,b", "say ""S""" ,c)", ','), (Words{"a,b", "say \"S\"", "c"}));
    EXPECT_EQ(cells_of(R"("two words" 3)", ' '), (Words{"two words", "3"}));
    EXPECT_EQ(cells_of(R"(" kept ";"")", ';'), (Words{" kept ", ""}));
    EXPECT_EQ(cells_of("1,,", ','), (Words{"1", "", ""}));
    EXPECT_EQ(cells_of("\t2\t", '\t'), (Words{"", "2", ""}));
    EXPECT_EQ(cells_of("  1   2  ", ' '), (Words{"1", "2"}));
    const WrittenFile file("\"t; in s\";\"S\"\n\"1.5\";2\n");
    const auto read = read_delimited(file.path());
    EXPECT_EQ(read.header, (Words{"t; in s", "S"}));
    EXPECT_EQ(all_columns(read), (Columns{{1.5}, {2}}));
}

TEST(DelimitedFile, AHeaderIsALineOfWordsWithoutANumber) {
    for (const auto& [first, header] : std::vector<std::pair<std::string, bool>>{
             {"t,S", true}, {"t,", true}, {"1,2", false}, {"nan,nan", false}, {"1,label", false}, {",2", false}}) {
        const WrittenFile file(first + "\n1,2\n");
        EXPECT_EQ(!read_delimited(file.path()).header.empty(), header) << first;
    }
}

TEST(DelimitedFile, AFirstRowOfBadNumbersIsNoHeader) {
    for (const std::string cell : {"1e400", "-1e999", "0x10"})
        for (const auto& first : {cell, cell + ",nan"}) {
            const WrittenFile file(first + "\n" + (first == cell ? "1\n2\n" : "1,1\n2,2\n"));
            const auto read = read_delimited(file.path());
            EXPECT_TRUE(read.header.empty()) << first;
            EXPECT_THAT(refusal([&] { all_columns(read); }), HasSubstr("line 1: '" + cell + "' in column 1 is not a"));
        }
    const WrittenFile named("inf,label\n1,2\n");
    EXPECT_EQ(read_delimited(named.path()).header, (Words{"inf", "label"}));
}

TEST(DelimitedFile, AMissingCellIsAGapWhereOneMayBe) {
    // inf is how TRex and MATLAB write what they have not found.
    const WrittenFile file("a,b\n1,\n2,nan\n3,NA\n4,inf\n5,-Infinity\n6,null\n7,#N/A\n8,5\n");
    const auto read = read_delimited(file.path());
    const auto b = numbers_of(read, {1}, {true}).front();
    for (std::size_t row = 0; row < 7; ++row) EXPECT_TRUE(std::isnan(b[row])) << row;
    EXPECT_EQ(b[7], 5);
    EXPECT_THAT(refusal([&] { numbers_of(read, {1}, {false}); }), HasSubstr("line 2"));
}

TEST(DelimitedFile, ABadCellIsNamedByFileLineAndText) {
    for (const std::string cell : {"abc", "1.2.3", "0x10", "1e999", "1 2", "--3"}) {
        const WrittenFile file("# c\nt,S\n0,1\n1," + cell + "\n");
        const auto said = refusal([&] { all_columns(read_delimited(file.path())); });
        EXPECT_THAT(said, HasSubstr(file.path()));
        EXPECT_THAT(said, HasSubstr("line 4: '" + cell + "' in column S is not a number"));
        EXPECT_THAT(said, HasSubstr("the line reads '1," + cell + "'"));
    }
    const WrittenFile ragged("1,2\n3\n");
    EXPECT_THAT(refusal([&] { all_columns(read_delimited(ragged.path())); }), HasSubstr("line 2: 1 cells, where 2"));
}

TEST(DelimitedFile, TextInAColumnThatIsNotAskedForIsNoMatter) {
    const WrittenFile file("t,who,S\n0,anna,1\n1,ben,2\n");
    EXPECT_EQ(numbers_of(read_delimited(file.path()), {0, 2}, {false, false}), (Columns{{0, 1}, {1, 2}}));
}

TEST(DelimitedFile, AColumnIsKnownByNameOrNumber) {
    const WrittenFile file("t,S,S\n1,2,3\n");
    const auto read = read_delimited(file.path());
    EXPECT_EQ(column_of(read, "--column", "t"), 0u);
    EXPECT_EQ(column_of(read, "--column", "3"), 2u);
    EXPECT_EQ(column_of(read, "--column", "T"), 0u);
    EXPECT_THAT(refusal([&] { column_of(read, "--column", "S"); }), HasSubstr("several"));
    for (const std::string wrong : {"x", "0", "4", "", "-1"})
        EXPECT_THAT(refusal([&] { column_of(read, "--column", wrong); }), HasSubstr("its columns are: t, S, S"));
}

TEST(DelimitedFile, ANameMayDifferInCaseSignsUnitOrGroup) {
    const WrittenFile file("Time (s),tip.x,tip.y,base.x,Angle [deg]\n1,2,3,4,5\n");
    const auto read = read_delimited(file.path());
    for (const auto& [wanted, column] : std::vector<std::pair<std::string, std::size_t>>{
             {"time", 0}, {"tip_x", 1}, {"TIP X", 1}, {"y", 2}, {"base.x", 3}, {"angle", 4}})
        EXPECT_EQ(column_of(read, "--column", wanted), column) << wanted;
    EXPECT_THAT(refusal([&] { column_of(read, "--column", "x"); }), HasSubstr("is no column"));  // two end in it
}

TEST(DelimitedFile, CarriageReturnsAloneEndLines) {
    const WrittenFile file("t,S\r0,1\r1,2");
    const auto read = read_delimited(file.path());
    EXPECT_EQ(read.header, (Words{"t", "S"}));
    EXPECT_EQ(all_columns(read), (Columns{{0, 1}, {1, 2}}));
}

TEST(DelimitedFile, BlankLinesBetweenTheRowsOfOneColumnAreGaps) {
    const WrittenFile file("S\n\n1\n\n# note\n\n4\n\n");
    const auto column = all_columns(read_delimited(file.path())).front();
    ASSERT_EQ(column.size(), 4u);
    EXPECT_TRUE(std::isnan(column[1]) && std::isnan(column[2]));
    EXPECT_EQ(column[0] + column[3], 5);
}

TEST(DelimitedFile, ADecimalCommaIsKnownWhereItIsNoSeparator) {
    for (const std::string separator : {";", "\t", " "}) {
        const WrittenFile file("t" + separator + "S\n0,0" + separator + "-1,5E-1\n0,5" + separator + "2\n");
        const auto read = read_delimited(file.path());
        EXPECT_EQ(all_columns(read), (Columns{{0, 0.5}, {-0.15, 2}})) << "separator '" << separator << "'";
    }
    const WrittenFile pairs("t,S\n0,0,1,5\n0,5,2,25\n");
    EXPECT_THAT(refusal([&] { read_delimited(pairs.path()); }),
                HasSubstr("4 cells between commas, where the header has 2"));
    LayoutChoice decimal_comma;
    decimal_comma.decimal_comma = true;
    EXPECT_EQ(all_columns(read_delimited(pairs.path(), decimal_comma)), (Columns{{0, 0.5}, {1.5, 2.25}}));
    const WrittenFile one("S\n0,25\n0,05\n");
    EXPECT_EQ(all_columns(read_delimited(one.path(), decimal_comma)), (Columns{{0.25, 0.05}}));
    const WrittenFile some("0,25\n3\n-1,5\n");
    EXPECT_EQ(all_columns(read_delimited(some.path(), decimal_comma)), (Columns{{0.25, 3, -1.5}}));
    EXPECT_THAT(refusal([&] { all_columns(read_delimited(some.path())); }), HasSubstr("line 2: 1 cells, where 2"));
}

TEST(DelimitedFile, TheLineOfTheHeaderMayBeNamed) {
    const WrittenFile file("run 7\n# t S\n0 1\n1 2\n");
    LayoutChoice choice;
    choice.header_line = 2;
    const auto read = read_delimited(file.path(), choice);
    EXPECT_EQ(read.header, (Words{"t", "S"}));
    EXPECT_EQ(all_columns(read), (Columns{{0, 1}, {1, 2}}));
    choice.header_line = 9;
    EXPECT_THAT(refusal([&] { read_delimited(file.path(), choice); }), HasSubstr("header-line = 9"));
}

TEST(DelimitedFile, APreambleHasAWordInEachLine) {
    const WrittenFile file("Dish 3\nby,A. Nobody\nt,S,error\n(s),,\n0,1,0.1\n1,2,0.1\n");
    const auto read = read_delimited(file.path());
    EXPECT_EQ(read.header, (Words{"t", "S", "error"}));
    EXPECT_EQ(read.layout.units, (Words{"(s)", "", ""}));
    EXPECT_THAT(read.layout.notes.front(), HasSubstr("lines 1 to 2 are above the table"));
    const WrittenFile ragged("1,2\n3,4,5\n6,7,8\n");  // a row that doesn't fit is no preamble
    EXPECT_THAT(refusal([&] { all_columns(read_delimited(ragged.path())); }), HasSubstr("line 2: 3 cells, where 2"));
}

TEST(DelimitedFile, TextThatIsNoUtf8AndControlsAreMadeHarmless) {
    const WrittenFile latin(
        "t;T [\xB0"
        "C]\n0;1\n1;2\n");
    EXPECT_EQ(read_delimited(latin.path()).header, (Words{"t",
                                                          "T [\xEF\xBF\xBD"
                                                          "C]"}));
    const WrittenFile escape("t,S\n0,1\n1,\x1b[31mred\n");
    EXPECT_THAT(refusal([&] { all_columns(read_delimited(escape.path())); }),
                testing::AllOf(HasSubstr("\\x1b[31mred"), testing::Not(HasSubstr("\x1b"))));
    for (const std::string& mark : {std::string("\xFF\xFE"), std::string()}) {
        const WrittenFile wide(mark + std::string("t\0,\0S\0\n\0", 8));
        EXPECT_THAT(refusal([&] { read_delimited(wide.path()); }), HasSubstr("is UTF-16 text"));
    }
}

TEST(DelimitedFile, TimesOfAClockAreSecondsAfterTheFirst) {
    const WrittenFile file("2026-02-28T23:59:59.5Z,1\n2026-03-01T01:00:00.25+01:00,2\n2026-03-01 00:00:02Z,3\n");
    const auto times = times_of(read_delimited(file.path()), 0);
    EXPECT_TRUE(times.of_clock);
    EXPECT_EQ(times.values, (std::vector<double>{0, 0.75, 2.5}));
    EXPECT_FALSE(clock_time_in("2026-02-30T00:00:00"));  // no such day
    EXPECT_FALSE(clock_time_in("12:60:00"));
    EXPECT_EQ(clock_time_in("1:02:03.5")->seconds, 3723);
}

TEST(DelimitedFile, FilesThatHoldNoSeriesAreRefused) {
    EXPECT_THAT(refusal([] { read_delimited("no/such/file.csv"); }), HasSubstr("No such file"));
    EXPECT_THAT(refusal([] { read_delimited(testing::TempDir()); }), HasSubstr("is a directory"));
    for (const std::string content : {"", "\n\n", "# only a comment\n", "t,S\n"}) {
        const WrittenFile file(content);
        EXPECT_THAT(refusal([&] { read_delimited(file.path()); }), HasSubstr("no rows")) << content;
    }
    const WrittenFile binary(std::string("\x89HDF\0\0", 6));
    EXPECT_THAT(refusal([&] { read_delimited(binary.path()); }), HasSubstr("not a text file"));
}

}  // namespace
