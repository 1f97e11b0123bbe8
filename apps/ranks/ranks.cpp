#include "apps/ranks/ranks.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/program.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <system_error>

namespace swirl::apps {

namespace {

constexpr const char* way_out = "give each a --shard of its own";

/// Where it was installed, or beside the program that was built. @throws BadInput where it is in neither place
std::string library_of_mpi(int started) {
    for (const char* folder : {SWIRL_LIBRARIES_FROM_PROGRAM, "."}) {
        const auto library = (folder_of_this_program() / folder / SWIRL_MPI_LIBRARY).lexically_normal();
        std::error_code unreadable;
        if (std::filesystem::is_regular_file(library, unreadable)) return library.string();
    }
    throw BadInput(
        fmt::format("{} processes were started together, and this build of swirl has no MPI: build it where MPI is "
                    "(libopenmpi-dev), or {}",
                    started, way_out));
}

/// Its signal handlers come before ours.
Communicator* join_others(int started) {
    // Global, as a library that a program is linked with: MPI loads parts of its own that look for it.
    void* const library = ::dlopen(library_of_mpi(started).c_str(), RTLD_NOW | RTLD_GLOBAL);
    void* const join = library == nullptr ? nullptr : ::dlsym(library, name_of_join_others);
    if (join == nullptr)
        throw BadInput(fmt::format("{} processes were started together, and MPI can't be loaded: {}; repair it, or {}",
                                   started, ::dlerror(), way_out));
    return reinterpret_cast<JoinOthers*>(join)();
}

}  // namespace

Ranks::Ranks() {
    const int started = processes_started_together();
    if (started == 1) return;
    Communicator* const others = join_others(started);
    if (others->count() != started)
        throw BadInput(
            fmt::format("{} processes were started together, of which the MPI of this build of swirl sees {}: start "
                        "them by its own launcher, or {}",
                        started, others->count(), way_out));
    others_ = others;
}

Ranks::~Ranks() {
    if (others_ == nullptr || is_interrupted()) return;
    // What is on its way to a rank that is gone may never arrive.
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    while (!others_->has_sent_all() && !is_interrupted() && (!lost_ || std::chrono::steady_clock::now() < limit)) {
    }
    if (!lost_) others_->leave();
}

void Ranks::send(int to, std::span<const std::byte> bytes) {
    if (others_ != nullptr) others_->send(to, bytes);
}

std::optional<Message> Ranks::receive() {
    return others_ == nullptr ? std::nullopt : others_->receive();
}

}  // namespace swirl::apps
