// The form of the results (table, JSON, record), and how much is printed beside them.
#pragma once

#include "apps/command_line/errors.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <string>

namespace swirl::apps {

enum class Accuracy { double_precision, extended, quad };

/// Refuses an empty name, which CLI11 takes for a flag that was not given.
inline CLI::Validator named_file() {
    return CLI::Validator(
        [](const std::string& name) { return std::string(name.empty() ? "a file's name is wanted" : ""); }, "");
}

struct OutputOptions {
    bool json = false;
    bool quiet = false;
    std::string record;
    int threads = 0;  ///< 0: all
    std::string accuracy_name = "double";

    void add_to(CLI::App& command, bool with_record = true) {
        command.add_flag("--json", json, "one JSON document on standard output, and nothing else")->group("Output");
        if (with_record)
            command.add_option("-o,--output", record, "write a record (HDF5)")
                ->type_name("FILE.h5")
                ->group("Output")
                ->check(named_file());
        command.add_flag("--quiet", quiet, "no progress and no messages")->group("Output");
        command.add_option("--threads", threads, "threads (default all); results do not depend on it")
            ->type_name("T")
            ->check(CLI::Range(0, 4096))
            ->group("Output");
        command.add_option("--accuracy", accuracy_name, "double (default), extended (80-bit) or quad (113-bit)")
            ->type_name("NAME")
            ->group("Output");
    }

    Accuracy accuracy() const {
        if (accuracy_name == "double") return Accuracy::double_precision;
        if (accuracy_name == "extended") return Accuracy::extended;
        if (accuracy_name == "quad") return Accuracy::quad;
        throw BadInput(fmt::format("accuracy = {} is none of: double, extended, quad", accuracy_name));
    }
};

}  // namespace swirl::apps
