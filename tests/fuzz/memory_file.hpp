// A file in memory, where there is a file system in memory, for functions that read files by their name. It is removed
// again; a process that crashes leaves one behind.
#pragma once

#include <stdlib.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace swirl::tests::fuzz {

class MemoryFile {
public:
    explicit MemoryFile(const std::string& content = {}) : name_(folder() + "/swirl-fuzz-XXXXXX") {
        descriptor_ = ::mkstemp(name_.data());
        if (descriptor_ >= 0 && write(content)) return;
        std::perror(name_.c_str());
        std::exit(1);
    }
    ~MemoryFile() {
        ::close(descriptor_);
        ::unlink(name_.c_str());
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    int descriptor() const { return descriptor_; }
    const std::string& name() const { return name_; }

private:
    static std::string folder() {
        const std::string memory = "/dev/shm";
        return ::access(memory.c_str(), W_OK) == 0 ? memory : std::filesystem::temp_directory_path().string();
    }
    bool write(const std::string& content) const {
        return ::write(descriptor_, content.data(), content.size()) == static_cast<ssize_t>(content.size());
    }

    std::string name_;
    int descriptor_ = -1;
};

}  // namespace swirl::tests::fuzz
