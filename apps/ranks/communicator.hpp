// What several processes talk by. It stands in a library of its own (mpi_communicator.cpp), which is loaded where a
// launcher started several: to load MPI alone takes 0.1 to 0.5 s (its network libraries PSM2 and UCX), which no other
// start is to pay.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace swirl::apps {

struct Message {
    int from = 0;
    std::vector<std::byte> bytes;
};

class Communicator {
public:
    Communicator() = default;
    virtual ~Communicator() = default;
    Communicator(const Communicator&) = delete;
    Communicator& operator=(const Communicator&) = delete;

    virtual int number() const = 0;
    virtual int count() const = 0;
    /// What can't be sent (the other is gone) is dropped.
    virtual void send(int to, std::span<const std::byte> bytes) = 0;
    /// The next message that has come, without waiting.
    virtual std::optional<Message> receive() = 0;
    /// Is nothing on its way any more?
    virtual bool has_sent_all() = 0;
    /// Waits for all others to come here.
    virtual void leave() = 0;
};

/// The function of the library that joins the other processes. What it gives lasts until the process ends.
using JoinOthers = Communicator*();
constexpr const char* name_of_join_others = "swirl_join_others";

}  // namespace swirl::apps
