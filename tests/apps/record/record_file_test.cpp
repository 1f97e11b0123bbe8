// The file as a whole: equal bytes, whole or not there, and what is said of bad ones.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "apps/record/output_file.hpp"
#include "apps/record/record_checksum.hpp"
#include "apps/record/record_reader.hpp"
#include "apps/record/record_writer.hpp"
#include "tests/apps/record/sample_record.hpp"
#include "tests/apps/record/scratch_folder.hpp"

namespace swirl::tests {
namespace {

using apps::RecordError;
using apps::RecordReader;
using apps::RecordWriter;

const apps::RecordHeader header{"a test", "0.1.0", "x86-64"};

std::string refusal_to_write(const std::filesystem::path& path) {
    return message_of<RecordError>([&] { RecordWriter(path, header); });
}

std::string refusal_to_read(const std::filesystem::path& path) {
    return message_of<RecordError>([&] { RecordReader reader(path); });
}

/// As a program writes it that knows of no checksum.
std::string without_checksum(const std::string& bytes) {
    return bytes.substr(0, bytes.size() - apps::trailer_bytes);
}

// Another second, another process, another folder, other garbage in fresh memory.
TEST(RecordFile, EqualWorkGivesEqualBytes) {
    const ScratchFolder first;
    const ScratchFolder second;
    const auto write = [](const std::string& garbage, const std::filesystem::path& path) {
        const std::string command = "MALLOC_PERTURB_=" + garbage + " '" SWIRL_WRITE_SAMPLE "' '" + path.string() + "'";
        return std::system(command.c_str());
    };
    ASSERT_EQ(write("17", first / "a.h5"), 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    ASSERT_EQ(write("170", second / "another.h5"), 0);
    write_sample_record(first / "again.h5");
    const std::string bytes = bytes_of(first / "a.h5");
    ASSERT_GT(bytes.size(), 10000U);
    EXPECT_TRUE(bytes == bytes_of(second / "another.h5"));
    EXPECT_TRUE(bytes == bytes_of(first / "again.h5"));
    EXPECT_EQ(bytes.find(first.path().string()), std::string::npos);
}

TEST(RecordFile, AppearsWholeOrNotAtAll) {
    const ScratchFolder folder;
    write_bytes(folder / "a.h5", "what was there before");
    {
        RecordWriter writer(folder / "a.h5", header);
        writer.root().attribute("x", 1.0);
        EXPECT_EQ(bytes_of(folder / "a.h5"), "what was there before");
        EXPECT_TRUE(std::filesystem::exists(folder / ".a.h5.partial"));
    }
    EXPECT_EQ(bytes_of(folder / "a.h5"), "what was there before");
    EXPECT_EQ(folder.files(), 1) << "an abandoned writer leaves nothing";
    RecordWriter writer(folder / "a.h5", header);
    writer.finish();
    EXPECT_EQ(RecordReader(folder / "a.h5").attribute<std::string>("/", "title"), "a test");
    EXPECT_EQ(folder.files(), 1);
}

TEST(RecordFile, AKilledWritersRemainsAreWrittenOver) {
    const ScratchFolder folder;
    write_bytes(folder / ".a.h5.partial", std::string(100000, 'x'));
    write_sample_record(folder / "a.h5");
    write_sample_record(folder / "b.h5");
    EXPECT_TRUE(bytes_of(folder / "a.h5") == bytes_of(folder / "b.h5"));
}

TEST(RecordFile, OneWriterAtATime) {
    const ScratchFolder folder;
    RecordWriter writer(folder / "a.h5", header);
    EXPECT_EQ(refusal_to_write(folder / "a.h5"),
              "cannot create record '" + (folder / "a.h5").string() + "': another process is writing it");
    writer.finish();
    EXPECT_EQ(RecordReader(folder / "a.h5").schema_version(), apps::record_schema_version);
}

TEST(RecordFile, ReplacesWhatALinkPointsTo) {
    const ScratchFolder folder;
    write_bytes(folder / "a.h5", "old");
    std::filesystem::create_symlink(folder / "a.h5", folder / "link.h5");
    RecordWriter(folder / "link.h5", header).finish();
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.h5"));
    EXPECT_EQ(RecordReader(folder / "a.h5").schema_version(), apps::record_schema_version);
}

TEST(RecordFile, PermissionsOfWhatIsReplacedStay) {
    using std::filesystem::perms;
    const ScratchFolder folder;
    for (const perms mode : {perms(0600), perms(0640), perms(0664), perms(0444) | perms::owner_write}) {
        write_bytes(folder / "a.h5", "old");
        std::filesystem::permissions(folder / "a.h5", mode);
        RecordWriter(folder / "a.h5", header).finish();
        EXPECT_EQ(std::filesystem::status(folder / "a.h5").permissions(), mode);
        EXPECT_EQ(RecordReader(folder / "a.h5").schema_version(), apps::record_schema_version);
    }
}

TEST(RecordFile, WhatIsUnfinishedIsRemovedOnLeaving) {
    const ScratchFolder folder;
    RecordWriter finished(folder / "whole.h5", header);
    finished.finish();
    const RecordWriter unfinished(folder / "cut.h5", header);
    EXPECT_EQ(folder.files(), 2);
    apps::remove_unfinished_files();
    EXPECT_EQ(folder.files(), 1);
    EXPECT_EQ(RecordReader(folder / "whole.h5").schema_version(), apps::record_schema_version);
}

TEST(RecordFile, OutputsThatCannotBeCreatedAreRefusedAtOnce) {
    const ScratchFolder folder;
    const auto message = [](const std::filesystem::path& path, const std::string& why) {
        return "cannot create record '" + path.string() + "': " + why;
    };
    const auto missing = folder / "no" / "a.h5";
    EXPECT_EQ(refusal_to_write(missing),
              message(missing, "directory '" + (folder / "no").string() + "' does not exist"));
    EXPECT_EQ(refusal_to_write(folder.path()), message(folder.path(), "it is a directory"));
    EXPECT_EQ(refusal_to_write(""), message("", "the name of a file is missing"));
    EXPECT_EQ(refusal_to_write("/dev/null"), message("/dev/null", "it exists and is not a regular file"));
    write_bytes(folder / "file", "");
    EXPECT_EQ(refusal_to_write(folder / "file" / "a.h5"),
              message(folder / "file" / "a.h5", "'" + (folder / "file").string() + "' is not a directory"));
    const auto long_name = folder / std::string(250, 'x');
    EXPECT_EQ(refusal_to_write(long_name), message(long_name, "File name too long"));
    EXPECT_EQ(folder.files(), 1);
}

TEST(RecordFile, PermissionIsAskedForAtOnce) {
    if (::geteuid() == 0) {  // whom no permission stops: the kernel's own files must do
        EXPECT_NE(refusal_to_write("/proc/a.h5").find("cannot create record '/proc/a.h5': "), std::string::npos);
        return;
    }
    const ScratchFolder folder;
    std::filesystem::permissions(folder.path(),
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    EXPECT_EQ(refusal_to_write(folder / "a.h5"),
              "cannot create record '" + (folder / "a.h5").string() + "': Permission denied");
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
}

void write_noise(const std::filesystem::path& path) {
    RecordWriter writer(path, header);
    writer.root().dimension("n", apps::growing);
    auto noise = writer.root().column<double>("noise", {"n"}, {"1", "noise", {}});
    std::mt19937_64 random(1);
    for (int i = 0; i < 100000; ++i) noise.append(static_cast<double>(random()));
    writer.finish();
}

// The files of at least so many bytes that are open here and have no name any more, by device and inode. Some are
// inherited, and others may write to those at any time: how their bytes grow tells nothing.
std::set<std::pair<dev_t, ino_t>> files_without_a_name(off_t bytes) {
    std::set<std::pair<dev_t, ino_t>> files;
    for (const auto& descriptor : std::filesystem::directory_iterator("/proc/self/fd")) {
        struct stat status {};
        const bool is_there = ::stat(descriptor.path().c_str(), &status) == 0;
        if (is_there && S_ISREG(status.st_mode) && status.st_nlink == 0 && status.st_size >= bytes)
            files.emplace(status.st_dev, status.st_ino);
    }
    return files;
}

// The limit on the size of a file stands for a full disk.
void write_beyond(rlim_t limit, const std::filesystem::path& path) {
    ::signal(SIGXFSZ, SIG_IGN);
    rlimit limits{};
    ::getrlimit(RLIMIT_FSIZE, &limits);
    const rlimit full{limit, limits.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &full);
    const auto known = files_without_a_name(0);
    const std::string message = message_of<RecordError>([&] { write_noise(path); });
    ::setrlimit(RLIMIT_FSIZE, &limits);
    std::fputs(message.c_str(), stderr);
    // The library must be of use afterwards, and exit() must not trip over what is left of the file.
    const auto next = path.parent_path() / "next.h5";
    write_sample_record(next);
    const auto held = files_without_a_name(1);
    const bool good = message.find("File too large") != std::string::npos &&
                      std::includes(known.begin(), known.end(), held.begin(), held.end()) &&
                      RecordReader(next).read<double>("/impacts/t").size() == sample_rows;
    std::filesystem::remove(next);
#ifdef SWIRL_SANITIZED
    std::_Exit(good ? 0 : 1);  // HDF5 never frees the cache of a file that it could not close: no report of that
#endif
    std::exit(good ? 0 : 1);
}

TEST(RecordFile, AFullDiskIsReportedAndHarmsNothing) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    // What is missing may be of the first write, of a chunk, of what finish() writes, of the checksum.
    const ScratchFolder whole;
    write_noise(whole / "a.h5");
    const auto bytes = static_cast<rlim_t>(bytes_of(whole / "a.h5").size());
    for (const rlim_t limit : {rlim_t{0}, rlim_t{500}, rlim_t{5000}, rlim_t{200000}, bytes - 1000, bytes - 1}) {
        const ScratchFolder folder;
        write_bytes(folder / "a.h5", "what was there before");
        EXPECT_EXIT(write_beyond(limit, folder / "a.h5"), testing::ExitedWithCode(0),
                    "record '.*a.h5': File too large");
        EXPECT_EQ(bytes_of(folder / "a.h5"), "what was there before");
        EXPECT_EQ(folder.files(), 1) << limit;
    }
}

TEST(RecordFile, BadFilesAreNamed) {
    const ScratchFolder folder;
    const auto message = [](const std::filesystem::path& path, const std::string& why) {
        return "cannot read record '" + path.string() + "': " + why;
    };
    EXPECT_EQ(refusal_to_read(folder / "no.h5"), message(folder / "no.h5", "No such file or directory"));
    EXPECT_EQ(refusal_to_read(folder.path()), message(folder.path(), "it is a directory"));
    write_bytes(folder / "empty.h5", "");
    EXPECT_EQ(refusal_to_read(folder / "empty.h5"), message(folder / "empty.h5", "it is not an HDF5 file"));
    write_bytes(folder / "text.h5", std::string(5000, 't'));
    EXPECT_EQ(refusal_to_read(folder / "text.h5"), message(folder / "text.h5", "it is not an HDF5 file"));
}

TEST(RecordFile, EveryTruncationIsFound) {
    const ScratchFolder folder;
    write_sample_record(folder / "a.h5");
    const std::string bytes = bytes_of(folder / "a.h5");
    for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 97) {
        write_bytes(folder / "cut.h5", bytes.substr(0, length));
        const std::string message = refusal_to_read(folder / "cut.h5");
        EXPECT_TRUE(message.starts_with("cannot read record '")) << length << ": " << message;
        EXPECT_EQ(message.find('\n'), std::string::npos);
    }
    const std::string cut = bytes.substr(0, bytes.size() - 1);
    write_bytes(folder / "cut.h5", cut);
    EXPECT_NE(refusal_to_read(folder / "cut.h5").find("it is damaged"), std::string::npos);
    write_bytes(folder / "cut.h5", without_checksum(cut));
    EXPECT_NE(refusal_to_read(folder / "cut.h5").find("it is damaged"), std::string::npos);
    write_bytes(folder / "cut.h5", without_checksum(bytes));  // what a writer of HDF5 leaves of it
    EXPECT_EQ(apps::wholeness_of(folder / "cut.h5"), apps::Wholeness::unstated);
    EXPECT_EQ(RecordReader(folder / "cut.h5").attribute<std::string>("/", "title"), "a sample");
}

TEST(RecordFile, EveryFlippedBitIsFound) {
    const ScratchFolder folder;
    write_sample_record(folder / "a.h5");
    const std::string bytes = bytes_of(folder / "a.h5");
    EXPECT_EQ(apps::wholeness_of(folder / "a.h5"), apps::Wholeness::whole);
    const std::size_t end = bytes.size() - apps::trailer_bytes;
    for (std::size_t place = 0; place < bytes.size(); place += place < end ? 1 + bytes.size() / 97 : 1) {
        std::string flipped = bytes;
        flipped[place] = static_cast<char>(flipped[place] ^ 0x10);
        write_bytes(folder / "a.h5", flipped);
        EXPECT_EQ(apps::wholeness_of(folder / "a.h5"), apps::Wholeness::damaged) << place;
        if (place >= end) continue;
        write_bytes(folder / "a.h5", without_checksum(flipped));
        EXPECT_EQ(apps::wholeness_of(folder / "a.h5"), apps::Wholeness::unstated) << place;
    }
}

// The CRC-64/XZ of "123456789" is published (CRC RevEng catalogue): 995dc9bbdf1939fa.
TEST(RecordFile, TheChecksumIsThePublishedOne) {
    const ScratchFolder folder;
    write_bytes(folder / "nine", "123456789");
    const apps::PosixFile file(::open((folder / "nine").c_str(), O_RDWR | O_CLOEXEC));
    apps::write_checksum(file.descriptor(), "nine");
    EXPECT_EQ(bytes_of(folder / "nine"),
              "123456789swirl record\ncrc-64/xz of the bytes before: 995dc9bbdf1939fa\n"
              "bytes: 00000000000000000098\n");
    EXPECT_EQ(apps::wholeness_of(folder / "nine"), apps::Wholeness::whole);
}

// Written before schema 2, with HDF5 1.10: a cycle of orbits near a point; its checksum is in a user block.
TEST(RecordFile, OneOfSchemaOneIsReadAndItsDamageIsFound) {
    const ScratchFolder folder;
    const std::string bytes = bytes_of(SWIRL_RECORD_OF_SCHEMA_1);
    ASSERT_TRUE(bytes.starts_with("swirl record\ncrc-64/xz of the bytes from 512 on: "));
    EXPECT_EQ(apps::wholeness_of(SWIRL_RECORD_OF_SCHEMA_1), apps::Wholeness::whole);
    EXPECT_TRUE(apps::has_checksum(SWIRL_RECORD_OF_SCHEMA_1));
    const auto holds_the_cycle = [](const std::filesystem::path& file) {
        const RecordReader record(file);
        return record.schema_version() == 1 &&
               record.read<std::int64_t>("/orbits/period") == std::vector<std::int64_t>{1};
    };
    EXPECT_TRUE(holds_the_cycle(SWIRL_RECORD_OF_SCHEMA_1));
    for (std::size_t place = apps::user_block_bytes; place < bytes.size(); place += 1 + bytes.size() / 97) {
        std::string flipped = bytes;
        flipped[place] = static_cast<char>(flipped[place] ^ 0x10);
        write_bytes(folder / "a.h5", flipped);
        EXPECT_EQ(apps::wholeness_of(folder / "a.h5"), apps::Wholeness::damaged) << place;
    }
    write_bytes(folder / "a.h5", bytes.substr(0, bytes.size() - 1));
    EXPECT_NE(refusal_to_read(folder / "a.h5").find("it is damaged"), std::string::npos);
    write_bytes(folder / "a.h5", std::string(apps::user_block_bytes, '\0') + bytes.substr(apps::user_block_bytes));
    EXPECT_EQ(apps::wholeness_of(folder / "a.h5"), apps::Wholeness::unstated);
    EXPECT_TRUE(holds_the_cycle(folder / "a.h5"));
}

TEST(RecordFile, ALaterSchemaAndAForeignFileAreRefused) {
    const ScratchFolder folder;
    const auto write = [&](const std::string& change) {
        const std::string path = (folder / "a.h5").string();
        RecordWriter(path, header).finish();
        const std::string command =
            "/usr/bin/python3 -c \"import h5py; f = h5py.File('" + path + "', 'r+'); " + change + "\"";
        if (const int code = std::system(command.c_str()); code != 0) return code;
        EXPECT_FALSE(apps::has_checksum(path)) << "who writes to it takes the checksum away";
        return 0;
    };
    const std::string prefix = "cannot read record '" + (folder / "a.h5").string() + "': ";
    ASSERT_EQ(write("f.attrs.modify('schema_version', 3)"), 0);
    EXPECT_EQ(refusal_to_read(folder / "a.h5"), prefix + "its schema_version is 3, this program reads 1 to 2");
    ASSERT_EQ(write("del f.attrs['schema_version']"), 0);
    EXPECT_EQ(refusal_to_read(folder / "a.h5"), prefix + "it has no schema_version, so it is not a Swirl record");
}

}  // namespace
}  // namespace swirl::tests
