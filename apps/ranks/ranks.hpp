// The processes that mpirun or srun started together: rank 0 hands out work and keeps the results, the others work.
// MPI stands behind this file alone (mpi_ranks.cpp; without_mpi.cpp where the build has none).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace swirl::apps {

/// How many processes were started together, as the launcher's environment says (Open MPI, MPICH, Slurm with PMIx);
/// 1 where none was. No library is asked, so that a process that stands alone pays nothing.
int processes_started_together();

struct Message {
    int from = 0;
    std::vector<std::byte> bytes;
};

class Ranks {
public:
    /// Joins the others: rank 0 of 1 if the process stands alone.
    /// @throws BadInput where several were started and this build has no MPI, or one that does not know the launcher
    Ranks();
    /// Waits for the others to come to their end, unless some of them was lost or the process is interrupted.
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    int number() const { return number_; }
    int count() const { return count_; }

    /// To be called from one thread, as receive() is. What can't be sent (the other is gone) is dropped.
    void send(int to, std::span<const std::byte> bytes);
    /// The next message that has come, without waiting.
    std::optional<Message> receive();
    /// Another rank is gone: the end must not wait for it.
    void lose() { lost_ = true; }

private:
    int number_ = 0;
    int count_ = 1;
    bool lost_ = false;
};

}  // namespace swirl::apps
