#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

namespace swirl::apps {

/// A file that means nothing until it is finished: one that is being written, a journal without an entry. While this
/// lives, remove_unfinished_files() removes it. The list has room for a few dozen; what does not fit is left to the
/// writer's own clearing up.
class UnfinishedFile {
public:
    UnfinishedFile() = default;
    explicit UnfinishedFile(const std::filesystem::path& path);
    UnfinishedFile(UnfinishedFile&& other) noexcept;
    UnfinishedFile& operator=(UnfinishedFile&& other) noexcept;
    ~UnfinishedFile() { finished(); }

    /// It has got its meaning, or is gone.
    void finished() noexcept;

private:
    std::optional<std::size_t> place_;
};

/// Removes them all; nothing is to be written to them afterwards. For a process that has to leave: may be called
/// from the handler of a signal, whatever the process was doing.
void remove_unfinished_files() noexcept;

}  // namespace swirl::apps
