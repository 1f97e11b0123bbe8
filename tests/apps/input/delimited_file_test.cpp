#include "apps/input/delimited_file.hpp"
#include "apps/command_line/errors.hpp"
#include "tests/apps/input/written_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

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
    for (const std::string cell : {"1e400", "inf", "-Infinity", "0x10"})
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
    const WrittenFile file("a,b\n1,\n2,nan\n3,NA\n4,5\n");
    const auto read = read_delimited(file.path());
    const auto b = numbers_of(read, {1}, {true}).front();
    EXPECT_TRUE(std::isnan(b[0]) && std::isnan(b[1]) && std::isnan(b[2]));
    EXPECT_EQ(b[3], 5);
    EXPECT_THAT(refusal([&] { numbers_of(read, {1}, {false}); }), HasSubstr("line 2"));
}

TEST(DelimitedFile, ABadCellIsNamedByFileLineAndText) {
    for (const std::string cell : {"abc", "1.2.3", "0x10", "inf", "1e999", "1 2", "--3"}) {
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
    EXPECT_THAT(refusal([&] { column_of(read, "--column", "S"); }), HasSubstr("several"));
    for (const std::string wrong : {"x", "0", "4", "", "-1"})
        EXPECT_THAT(refusal([&] { column_of(read, "--column", wrong); }), HasSubstr("its columns are: t, S, S"));
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
