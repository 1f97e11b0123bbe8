#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace swirl::apps {

/// What went wrong with a file, in one line: "cannot create record 'out/a.h5': directory 'out' does not exist".
class RecordError : public std::runtime_error {
public:
    explicit RecordError(const std::string& line) : std::runtime_error(line) {}
    RecordError(std::string_view action, std::string_view path, std::string_view reason)
        : std::runtime_error(std::string(action) + " '" + std::string(path) + "': " + std::string(reason)) {}
};

}  // namespace swirl::apps
