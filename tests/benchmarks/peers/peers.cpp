// The compiled peers behind one prompt, so that compare.py can have them and those in Python run in turns:
//
//     scene disk|hexagon|rough-hexagon|elastic-rough-hexagon|dry-disk|dry-hexagon SEED COUNT
//         COUNT flights drawn, eight in a row of each orbit: as many lines, a start and quad's impact (over a floor
//         with dry friction double's)
//     next PEER TOLERANCE STEP COUNT
//         one impact from each of the first COUNT starts: as many lines
//     row PEER TOLERANCE STEP FIRST COUNT
//         COUNT impacts in a row from start FIRST: as many lines, or up to the one that is not found
//     follow PEER TOLERANCE STEP FIRST COUNT SECONDS
//         the same, again and again for SECONDS: seconds of the processor per impact, impacts found
//     numbers
//         Box2D's
//
// A start is ψ (x y), χ (x y), v_n, v_t, S; an impact: found, time, vertex and the state after it.
#include "peer.hpp"
#include "tests/map/random_scenes.hpp"

#include <cstdint>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace swirl;
using namespace swirl::peers;

Scene<double> scene_named(const std::string& name) {
    if (name == "dry-disk" || name == "dry-hexagon") {
        Scene<double> dry = scene_named(name == "dry-disk" ? "disk" : "rough-hexagon");
        dry.floor_friction = 0.05;
        dry.gravity_ratio = 1;
        return dry;
    }
    if (name != "disk" && name != "hexagon" && name != "rough-hexagon" && name != "elastic-rough-hexagon")
        throw std::runtime_error("scene " + name);
    const int sides = name == "disk" ? disk_sides : 6;
    const double mu = name == "hexagon" ? 0.0 : 0.5, restitution = name == "rough-hexagon" ? 0.95 : 1.0;
    return {sides, 0.3, 0.5, mu, restitution, Law::poisson, uniform_inertia_factor<double>(sides)};
}

std::unique_ptr<Peer> make_peer(const std::string& name, const Scene<double>& scene, const Settings& settings) {
    if (auto own = make_swirl_peer(name, scene)) return own;
    std::unique_ptr<Peer> peer;
    if (name == "sundials") peer = make_sundials_peer(scene, settings);
    if (name == "box2d") peer = make_box2d_peer(scene, settings);
    if (!peer) throw std::runtime_error("peer " + name);
    return peer;
}

/// The first eight impacts after random states on the section.
std::vector<State> draw(const Scene<double>& scene, std::uint64_t seed, std::size_t count) {
    const auto map = make_swirl_peer("double", scene);
    tests::Random random(seed);
    std::vector<State> starts;
    while (starts.size() < count) {
        const double leaving = random.between(0.05, 1);
        State state = post_impact_state(tests::random_point(random, scene, leaving));
        for (int i = 0; i < 8 && map->follow(state, 1) == 1; ++i) starts.push_back(state);
    }
    starts.resize(count);
    return starts;
}

void print(const State& z) {
    std::printf("%.17g %.17g %.17g %.17g %.17g %.17g %.17g", z.psi.x, z.psi.y, z.chi.x, z.chi.y, z.vn, z.vt, z.spin);
}
void print(const Impact& impact) {
    std::printf("%d %.17g %d ", impact.found ? 1 : 0, impact.time, impact.vertex);
    print(impact.after);
    std::printf("\n");
}

class Prompt {
public:
    void answer(const std::string& line) {
        std::istringstream in(line);
        std::string what, name;
        in >> what;
        if (what == "numbers") return static_cast<void>(std::printf("%s\n", box2d_numbers(scene_).c_str()));
        in >> name;
        if (what == "scene") return begin(name, in);
        Settings settings;
        std::size_t first = 0, count = 0;
        double seconds = 0;
        in >> settings.tolerance >> settings.step;
        if (what != "next") in >> first;
        in >> count;
        if (what == "follow") in >> seconds;
        if (!in || first >= starts_.size()) throw std::runtime_error("cannot read: " + line);
        const auto peer = make_peer(name, scene_, settings);
        if (what == "next")
            for (std::size_t i = 0; i < count; ++i) print(peer->next(starts_.at(i)));
        else if (what == "row")
            for (const Impact& impact : peer->row(starts_[first], count)) print(impact);
        else if (what == "follow")
            follow(*peer, first, count, seconds);
        else
            throw std::runtime_error("unknown: " + line);
    }

private:
    void begin(const std::string& name, std::istream& in) {
        std::uint64_t seed = 0;
        std::size_t count = 0;
        if (!(in >> seed >> count)) throw std::runtime_error("scene NAME SEED COUNT");
        scene_ = scene_named(name);
        starts_ = draw(scene_, seed, count);
        const auto quad = make_swirl_peer(scene_.has_dry_floor() ? "double" : "quad", scene_);
        for (const State& start : starts_) {
            print(start);
            std::printf(" ");
            print(quad->next(start));
        }
    }
    void follow(Peer& peer, std::size_t first, std::size_t count, double seconds) const {
        long found = 0;
        const std::clock_t begin = std::clock();  // the processor's: other processes may run meanwhile
        double passed = 0;
        do {
            found += peer.follow_from(starts_, first, count);
            passed = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        } while (passed < seconds);
        std::printf("%.9g %ld\n", passed / static_cast<double>(found), found);
    }

    Scene<double> scene_ = scene_named("disk");
    std::vector<State> starts_;
};

}  // namespace

int main() {
    Prompt prompt;
    try {
        for (std::string line; std::getline(std::cin, line);) {
            prompt.answer(line);
            std::fflush(stdout);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "peers: %s\n", error.what());
        return 2;
    }
}
