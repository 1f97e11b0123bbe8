#include "apps/record/journal.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tests/apps/record/scratch_folder.hpp"

namespace swirl::tests {
namespace {

using apps::Journal;
using apps::JournalMismatch;
using apps::RecordError;
using Entries = std::vector<std::pair<std::uint64_t, std::string>>;

std::span<const std::byte> bytes(const std::string& text) {
    return std::as_bytes(std::span(text));
}

const std::string header = "scene and options";

Journal open(const std::filesystem::path& path, Entries& entries, const std::string& head = header) {
    return Journal(path, bytes(head), [&](std::uint64_t index, std::span<const std::byte> payload) {
        entries.emplace_back(index, std::string(reinterpret_cast<const char*>(payload.data()), payload.size()));
    });
}

Entries entries_of(const std::filesystem::path& path) {
    Entries entries;
    open(path, entries);
    return entries;
}

const Entries sample{{7, "seven"}, {0, ""}, {18446744073709551615U, std::string(100000, 'x')}, {3, "three"}};

void write_sample_journal(const std::filesystem::path& path) {
    Entries none;
    Journal journal = open(path, none);
    for (const auto& [index, payload] : sample) journal.append(index, bytes(payload));
    journal.flush();
}

TEST(Journal, EntriesComeBackInOrderAndMoreMayFollow) {
    const ScratchFolder folder;
    write_sample_journal(folder / "j");
    Entries entries;
    {
        Journal journal = open(folder / "j", entries);
        EXPECT_EQ(entries, sample);
        journal.append(9, bytes("nine"));
        journal.flush();
    }
    Entries longer = sample;
    longer.emplace_back(9, "nine");
    EXPECT_EQ(entries_of(folder / "j"), longer);
}

TEST(Journal, ATornTailIsCutOffWhereverItIsTorn) {
    const ScratchFolder folder;
    write_sample_journal(folder / "j");
    const std::string whole = bytes_of(folder / "j");
    const std::size_t last = 8 + 4 + 5 + 4;  // index, length, "three", CRC
    const Entries but_last(sample.begin(), sample.end() - 1);
    for (std::size_t cut = 1; cut <= last; ++cut) {
        write_bytes(folder / "j", whole.substr(0, whole.size() - cut));
        EXPECT_EQ(entries_of(folder / "j"), but_last) << cut;
        EXPECT_EQ(std::filesystem::file_size(folder / "j"), whole.size() - last);
        Entries entries;
        Journal journal = open(folder / "j", entries);
        journal.append(3, bytes("three"));
        journal.flush();
        EXPECT_TRUE(bytes_of(folder / "j") == whole);
    }
}

TEST(Journal, ADamagedEntryEndsIt) {
    const ScratchFolder folder;
    write_sample_journal(folder / "j");
    const std::string whole = bytes_of(folder / "j");
    const std::size_t last = 8 + 4 + 5 + 4;
    const Entries but_last(sample.begin(), sample.end() - 1);
    for (std::size_t back = 1; back <= last; ++back) {
        std::string damaged = whole;
        damaged[damaged.size() - back] = static_cast<char>(damaged[damaged.size() - back] ^ 0x10);
        write_bytes(folder / "j", damaged);
        EXPECT_EQ(entries_of(folder / "j"), but_last) << back;
    }
    write_bytes(folder / "j", whole + std::string(4096, '\0'));  // as a file system may leave it after a power cut
    EXPECT_EQ(entries_of(folder / "j"), sample);
}

TEST(Journal, AnotherHeaderIsRefusedAndTheFileKept) {
    const ScratchFolder folder;
    write_sample_journal(folder / "j");
    const std::string whole = bytes_of(folder / "j");
    for (const std::string other : {"scene and optionS", "scene", "scene and options and more", ""}) {
        Entries entries;
        EXPECT_EQ(message_of<JournalMismatch>([&] { open(folder / "j", entries, other); }),
                  "cannot open journal '" + (folder / "j").string() + "': it was begun with other options");
        EXPECT_TRUE(entries.empty());
    }
    EXPECT_TRUE(bytes_of(folder / "j") == whole);
}

TEST(Journal, AHeaderCutShortIsBegunAgain) {
    const ScratchFolder folder;
    Entries entries;
    open(folder / "j", entries);
    const std::string head = bytes_of(folder / "j");
    for (std::size_t length = 0; length < head.size(); ++length) {
        write_bytes(folder / "j", head.substr(0, length));
        EXPECT_TRUE(entries_of(folder / "j").empty());
        EXPECT_TRUE(bytes_of(folder / "j") == head);
    }
}

TEST(Journal, ForeignAndUnwritableFilesAreRefused) {
    const ScratchFolder folder;
    const auto refusal = [](const std::filesystem::path& path) {
        return message_of<RecordError>([&] { entries_of(path); });
    };
    write_bytes(folder / "text", "dear diary, today I rolled");
    EXPECT_EQ(refusal(folder / "text"),
              "cannot open journal '" + (folder / "text").string() + "': it is not a journal");
    EXPECT_EQ(bytes_of(folder / "text"), "dear diary, today I rolled");
    EXPECT_NE(refusal(folder / "no" / "j").find("does not exist"), std::string::npos);
    EXPECT_NE(refusal(folder.path()).find("it is a directory"), std::string::npos);
    Entries entries;
    const Journal journal = open(folder / "j", entries);
    EXPECT_NE(refusal(folder / "j").find("another process is writing it"), std::string::npos);
}

TEST(Journal, LiesHiddenBesideItsRecordAndGoes) {
    const ScratchFolder folder;
    const auto path = apps::journal_path(folder / "sweep.h5");
    EXPECT_EQ(path, folder / ".sweep.h5.journal");
    Entries entries;
    open(path, entries).remove();
    EXPECT_EQ(folder.files(), 0);
}

// A process that is killed while it appends: what it had flushed is there, and every entry that is there is whole.
TEST(Journal, SigkillLosesAtMostWhatWasNotFlushed) {
    const ScratchFolder folder;
    int flushed[2];
    ASSERT_EQ(::pipe(flushed), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        Entries none;
        Journal journal = open(folder / "j", none);
        for (std::uint64_t index = 0;; ++index) {
            journal.append(index, bytes(std::string(1000 + index % 1000, static_cast<char>('a' + index % 26))));
            if (index % 10 == 9) {
                journal.flush();
                if (::write(flushed[1], "x", 1) != 1) ::_exit(1);
            }
        }
    }
    char byte = 0;
    for (int batch = 0; batch < 20; ++batch) ASSERT_EQ(::read(flushed[0], &byte, 1), 1);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(flushed[0]);
    ::close(flushed[1]);
    const Entries entries = entries_of(folder / "j");
    ASSERT_GE(entries.size(), 200U);
    for (std::uint64_t i = 0; i < entries.size(); ++i) {
        ASSERT_EQ(entries[i].first, i);
        ASSERT_EQ(entries[i].second, std::string(1000 + i % 1000, static_cast<char>('a' + i % 26)));
    }
}

}  // namespace
}  // namespace swirl::tests
