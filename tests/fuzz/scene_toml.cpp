// A scene file: any text. It is refused, or it is a scene within its ranges, in each arithmetic.
#include "apps/command_line/program.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/command_line/start_options.hpp"
#include "map/numbers/quad.hpp"
#include "tests/fuzz/bytes.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/outcome.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace swirl::apps {
namespace {

struct ReadScene {
    SceneOptions scene;
    StartOptions start;

    void add_to(Flags& command) {
        scene.add_to(command);
        start.add_to(command);
    }
};

template <class T>
void require_scene(const ReadScene& options) {
    const Scene<T> scene = options.scene.scene<T>();
    validated(scene);
    options.start.start<T>(scene);
}

int read_scene(ReadScene& options) {
    using tests::fuzz::answers, tests::fuzz::require;
    if (!answers([&] { options.scene.read_file(); })) return exit_bad_input;
    if (!answers([&] { options.start.take_from(options.scene); })) return exit_bad_input;
    const bool good = answers([&] { require_scene<double>(options); });
    answers([&] { require_scene<long double>(options); });
    answers([&] { require_scene<Quad>(options); });
    if (!good) return exit_bad_input;
    if (const auto units = options.scene.units())
        require(units->length > 0 && units->time > 0 && units->mass > 0, "units are positive");
    require(!std::isnan(options.start.speed()), "a start's speed is a number");
    return exit_done;
}

}  // namespace
}  // namespace swirl::apps

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace swirl;
    const tests::fuzz::MemoryFile file(tests::fuzz::Bytes(data, size).rest());
    std::string words[] = {"swirl", "read", "--scene", file.name()};
    char* argv[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data()};
    apps::Program program("", "", "");
    program.add_command<apps::ReadScene>("read", "", "", apps::read_scene);
    program.called(4, argv)();
    return 0;
}
