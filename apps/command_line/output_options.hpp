// The form of the results (table, JSON, record), and how much is printed beside them.
#pragma once

#include "apps/command_line/accuracy.hpp"
#include "apps/command_line/flags.hpp"

#include <string>

namespace swirl::apps {

/// Adds an option that names a file. An empty name, which CLI11 takes for a flag that was not given, is refused.
Flag add_file(Flags& command, const std::string& flag, std::string& file, const std::string& type,
              const std::string& help);

struct OutputOptions {
    bool json = false;
    bool quiet = false;
    std::string record;
    std::string command;  ///< the command's name, as its records say it
    bool force = false;
    int threads = 0;  ///< 0: all
    std::string accuracy_name = "double";

    void add_to(Flags& command, bool with_record = true);

    /// @throws BadInput for a name that is none
    Accuracy accuracy() const { return accuracy_from(accuracy_name); }
    /// @throws BadInput for a name other than double's, with the reason
    void require_double(const std::string& why) const;
};

}  // namespace swirl::apps
