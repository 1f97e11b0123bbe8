// The processes that mpirun or srun started together: rank 0 hands out work and keeps the results, the others work.
#pragma once

#include "apps/ranks/communicator.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace swirl::apps {

/// How many processes were started together, as the launcher's environment says (Open MPI, MPICH, Slurm with PMIx);
/// 1 where none was. No library is asked, so that a process that stands alone pays nothing.
int processes_started_together();

class Ranks {
public:
    /// Joins the others: rank 0 of 1 if the process stands alone.
    /// @throws BadInput where several were started and this build has no MPI, one that can't be loaded, or one that
    /// does not know the launcher
    Ranks();
    /// Waits for the others to come to their end, unless some of them was lost or the process is interrupted.
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    int number() const { return others_ ? others_->number() : 0; }
    int count() const { return others_ ? others_->count() : 1; }

    /// To be called from one thread, as receive() is. What can't be sent (the other is gone) is dropped.
    void send(int to, std::span<const std::byte> bytes);
    /// The next message that has come, without waiting.
    std::optional<Message> receive();
    /// Another rank is gone: the end must not wait for it.
    void lose() { lost_ = true; }

private:
    Communicator* others_ = nullptr;  // lasts until the process ends
    bool lost_ = false;
};

}  // namespace swirl::apps
