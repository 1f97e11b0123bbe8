// The library that is loaded for ranks: all of MPI that Swirl knows.
#include "apps/ranks/communicator.hpp"

// Not the C++ bindings of MPI 2, which need another library.
#define OMPI_SKIP_MPICXX
#define MPICH_SKIP_MPICXX
#include <mpi.h>

#include <cstddef>
#include <list>
#include <optional>
#include <span>
#include <vector>

namespace swirl::apps {

namespace {

constexpr int tag = 0;

/// What is on its way: its bytes must stay until they are sent.
struct Sending {
    std::vector<std::byte> bytes;
    MPI_Request request = MPI_REQUEST_NULL;
};

class MpiCommunicator : public Communicator {
public:
    MpiCommunicator() {
        int provided = 0;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
        MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);  // a rank that is gone is no end of the others
        MPI_Comm_rank(MPI_COMM_WORLD, &number_);
        MPI_Comm_size(MPI_COMM_WORLD, &count_);
    }

    int number() const override { return number_; }
    int count() const override { return count_; }

    void send(int to, std::span<const std::byte> bytes) override {
        has_sent_all();
        Sending& sending = sendings_.emplace_back();
        sending.bytes.assign(bytes.begin(), bytes.end());
        const int failed = MPI_Isend(sending.bytes.data(), static_cast<int>(sending.bytes.size()), MPI_BYTE, to, tag,
                                     MPI_COMM_WORLD, &sending.request);
        if (failed != MPI_SUCCESS) sendings_.pop_back();
    }

    std::optional<Message> receive() override {
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

    bool has_sent_all() override {
        sendings_.remove_if([](Sending& sending) {
            int done = 0;
            return MPI_Test(&sending.request, &done, MPI_STATUS_IGNORE) != MPI_SUCCESS || done != 0;
        });
        return sendings_.empty();
    }

    void leave() override { MPI_Finalize(); }

private:
    int number_ = 0;
    int count_ = 1;
    std::list<Sending> sendings_;
};

}  // namespace

extern "C" [[gnu::visibility("default")]] Communicator* swirl_join_others() {
    // Never destroyed: what is on its way may be read until the process ends.
    static Communicator* const communicator = new MpiCommunicator;
    return communicator;
}

}  // namespace swirl::apps
