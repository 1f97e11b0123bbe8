// A command line: a word a line. The whole program reads it; nothing is run but what reads a scene, a start and the
// ranges of parameters, so that no input can write a file or compute for hours.
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/command_line/parameter_range.hpp"
#include "apps/commands.hpp"
#include "apps/input/input_options.hpp"
#include "map/numbers/quad.hpp"
#include "tests/fuzz/bytes.hpp"
#include "tests/fuzz/outcome.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace swirl::apps {
namespace {

using tests::fuzz::answers, tests::fuzz::require;

/// What most commands share, and the texts that they take apart themselves.
struct ReadOptions {
    InputOptions input;
    OutputOptions output;
    std::string along, plane;
    std::int64_t count = 0;
    double step = 0;

    void add_to(Flags& command) {
        input.add_to(command);
        output.add_to(command);
        command.add_option("--along", along, "");
        command.add_option("--plane", plane, "");
        command.add_option("--count", count, "")->transform(whole_number(1, 1000));
        command.add_option("--step", step, "")->check(finite_number_from(0));
    }
};

void require_range(const ParameterRange& range) {
    require(std::isfinite(range.low) && std::isfinite(range.high) && range.low < range.high, "a range is finite");
    for (const double column : range.columns)
        require(range.low <= column && column <= range.high, "columns lie in their range");
}

template <class T>
void read_scene(const ReadOptions& options) {
    const Scene<T> scene = options.input.scene.scene<T>();
    validated(scene);
    options.input.start.start<T>(scene);
}

/// No file is opened.
int read_shared(ReadOptions& options) {
    require(options.count >= 0 && options.count <= 1000, "a count is in its range");
    require(std::isfinite(options.step) && options.step >= 0, "a step is finite");
    answers([&] { options.input.range(); });
    answers([&] { options.output.accuracy(); });
    answers([&] { require_range(parameter_range_from(options.along, true, true)); });
    answers([&] { require_range(parameter_range_from(options.plane, false, false, "plane")); });
    if (!options.input.scene.file().empty()) return exit_done;
    answers([&] { options.input.scene.read_file(); });
    if (!answers([&] { options.input.start.take_from(options.input.scene); })) return exit_bad_input;
    answers([&] { read_scene<double>(options); });
    answers([&] { read_scene<long double>(options); });
    answers([&] { read_scene<Quad>(options); });
    answers([&] { options.input.start.require_seeds(1000); });
    return exit_done;
}

std::vector<std::string> words_from(tests::fuzz::Bytes bytes) {
    std::vector<std::string> words{"swirl"};
    const std::string text = bytes.rest();
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        words.push_back(text.substr(begin, std::min(end - begin, text.find('\0', begin) - begin)));
        begin = end + 1;
    }
    return words;
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    return argv;
}

/// What the command line asks for; nothing if it is refused.
Program::Action called(Program& program, std::vector<std::string> words) {
    std::vector<char*> argv = pointers_to(words);
    Program::Action action;
    answers([&] { action = program.called(static_cast<int>(words.size()), argv.data()); });
    return action;
}

}  // namespace
}  // namespace swirl::apps

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace swirl::apps;
    std::vector<std::string> words = words_from({data, size});
    Program whole("swirl", "0", "");
    add_commands(whole);
    called(whole, words);
    // Once more as the one command that may run.
    if (words.size() < 2) return 0;
    words[1] = "read";
    if (std::find(words.begin(), words.end(), "--help") != words.end()) return 0;
    if (std::find(words.begin(), words.end(), "-h") != words.end()) return 0;
    Program reader("swirl", "0", "");
    reader.add_command<ReadOptions>("read", "", "", read_shared);
    if (const auto action = called(reader, words)) action();
    return 0;
}
