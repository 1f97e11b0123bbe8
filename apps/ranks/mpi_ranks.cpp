#include "apps/command_line/errors.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/ranks/ranks.hpp"

// Not the C++ bindings of MPI 2, which need another library.
#define OMPI_SKIP_MPICXX
#define MPICH_SKIP_MPICXX
#include <mpi.h>

#include <fmt/format.h>

#include <chrono>
#include <list>

namespace swirl::apps {

namespace {

constexpr int tag = 0;

/// What is on its way: its bytes must stay until they are sent.
struct Sending {
    std::vector<std::byte> bytes;
    MPI_Request request = MPI_REQUEST_NULL;
};

/// MPI is one for a process, whatever its objects are.
std::list<Sending>& sendings() {
    static std::list<Sending> list;
    return list;
}

void forget_what_is_sent() {
    sendings().remove_if([](Sending& sending) {
        int done = 0;
        return MPI_Test(&sending.request, &done, MPI_STATUS_IGNORE) != MPI_SUCCESS || done != 0;
    });
}

}  // namespace

Ranks::Ranks() {
    if (processes_started_together() == 1) return;
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);  // its signal handlers come before ours
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);         // a rank that is gone is no end of the others
    MPI_Comm_rank(MPI_COMM_WORLD, &number_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    const int started = processes_started_together();
    if (count_ != started)
        throw BadInput(
            fmt::format("{} processes were started together, of which the MPI of this build of swirl sees {}: start "
                        "them by its own launcher, or give each a --shard of its own",
                        started, count_));
}

Ranks::~Ranks() {
    if (count_ == 1 || is_interrupted()) return;
    // What is on its way to a rank that is gone may never arrive.
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    while (!sendings().empty() && !is_interrupted() && (!lost_ || std::chrono::steady_clock::now() < limit))
        forget_what_is_sent();
    if (!lost_) MPI_Finalize();
}

void Ranks::send(int to, std::span<const std::byte> bytes) {
    forget_what_is_sent();
    Sending& sending = sendings().emplace_back();
    sending.bytes.assign(bytes.begin(), bytes.end());
    const int failed = MPI_Isend(sending.bytes.data(), static_cast<int>(sending.bytes.size()), MPI_BYTE, to, tag,
                                 MPI_COMM_WORLD, &sending.request);
    if (failed != MPI_SUCCESS) sendings().pop_back();
}

std::optional<Message> Ranks::receive() {
    if (count_ == 1) return {};
    int there = 0;
    MPI_Status status;
    if (MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &there, &status) != MPI_SUCCESS || there == 0) return {};
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    Message message{status.MPI_SOURCE, std::vector<std::byte>(static_cast<std::size_t>(size))};
    if (MPI_Recv(message.bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE) !=
        MPI_SUCCESS)
        return {};
    return message;
}

}  // namespace swirl::apps
