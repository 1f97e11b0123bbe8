// A file in the test's folder for temporary files, removed afterwards.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace swirl::tests {

class WrittenFile {
public:
    explicit WrittenFile(const std::string& content) {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        path_ = testing::TempDir() + "swirl-" + info->test_suite_name() + "-" + info->name() + ".csv";
        std::ofstream(path_, std::ios::binary) << content;
    }
    ~WrittenFile() { std::filesystem::remove(path_); }
    WrittenFile(const WrittenFile&) = delete;
    WrittenFile& operator=(const WrittenFile&) = delete;

    const std::string& path() const { return path_; }

private:
    std::string path_;
};

}  // namespace swirl::tests
