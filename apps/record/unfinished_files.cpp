#include "apps/record/unfinished_files.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>
#include <utility>

namespace swirl::apps {

namespace {

enum class State { free, filled, armed };

struct Place {
    std::atomic<State> state{State::free};
    std::array<char, PATH_MAX> path{};
};

// What the handler of a signal can reach is global, and memory that is never given back.
std::array<Place, 32> places;
static_assert(std::atomic<State>::is_always_lock_free, "a handler must not wait for a lock");

}  // namespace

UnfinishedFile::UnfinishedFile(const std::filesystem::path& path) {
    if (path.native().size() >= PATH_MAX) return;
    for (std::size_t i = 0; i < places.size(); ++i) {
        State expected = State::free;
        if (!places[i].state.compare_exchange_strong(expected, State::filled)) continue;
        std::memcpy(places[i].path.data(), path.c_str(), path.native().size() + 1);
        places[i].state = State::armed;
        place_ = i;
        return;
    }
}

UnfinishedFile::UnfinishedFile(UnfinishedFile&& other) noexcept : place_(std::exchange(other.place_, std::nullopt)) {}

UnfinishedFile& UnfinishedFile::operator=(UnfinishedFile&& other) noexcept {
    std::swap(place_, other.place_);
    return *this;
}

void UnfinishedFile::finished() noexcept {
    if (place_) places[*place_].state = State::free;
    place_.reset();
}

void remove_unfinished_files() noexcept {
    for (const Place& place : places)
        if (place.state == State::armed) ::unlink(place.path.data());
}

}  // namespace swirl::apps
