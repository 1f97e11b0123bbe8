// Threads that take pieces of work from a queue, for a process that does other things meanwhile.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

namespace swirl::apps {

/// What a piece gives, as bytes; nothing: it was stopped.
using PieceWork = std::function<std::optional<std::vector<std::byte>>(std::size_t)>;

struct PieceResult {
    std::size_t piece = 0;
    std::vector<std::byte> bytes;
};

class Workers {
public:
    /// So many threads (0: all that the process may use).
    Workers(int threads, PieceWork work);
    /// Pieces at hand are ended, those that wait are dropped. After an interruption threads are left alone.
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    int threads() const { return threads_; }
    void add(std::span<const std::size_t> pieces);
    std::size_t waiting() const;
    /// What has ended since the last call. Exceptions of a piece are passed on.
    std::vector<PieceResult> results();

private:
    struct Shared {
        PieceWork work;
        std::mutex mutex;
        std::condition_variable changed;
        std::deque<std::size_t> waiting;
        std::vector<PieceResult> results;
        std::exception_ptr failure;
        bool ended = false;
    };
    static void run(Shared& shared);

    int threads_;
    std::shared_ptr<Shared> shared_;
    std::vector<std::thread> pool_;
};

}  // namespace swirl::apps
