// Threads that take pieces of work from a queue, for a process that does other things meanwhile.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

namespace swirl::apps {

/// What a piece gives, as bytes.
struct PieceResult {
    std::size_t piece = 0;
    std::vector<std::byte> bytes;
};

/// Works at some pieces together and gives `keep` the result of each as soon as it has it; of one that was stopped it
/// gives none.
using KeepPiece = std::function<void(PieceResult)>;
using PieceWork = std::function<void(std::span<const std::size_t> pieces, const KeepPiece& keep)>;

class Workers {
public:
    /// So many threads (0: all that the process may use), each of which takes at most so many pieces together.
    Workers(int threads, std::size_t most_together, PieceWork work);
    /// Pieces at hand are ended, those that wait are dropped. After an interruption threads are left alone: what they
    /// work with lives on.
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    void add(std::span<const std::size_t> pieces);
    /// So few wait that it is time for the next: in good time for those that are worked at together.
    bool wants_more() const;
    /// What has ended since the last call. Exceptions of a piece are passed on.
    std::vector<PieceResult> results();

private:
    struct Shared {
        PieceWork work;
        std::size_t threads = 1, most_together = 1;
        std::mutex mutex;
        std::condition_variable changed;
        std::deque<std::size_t> waiting;
        std::size_t last_added = 0;
        std::vector<PieceResult> results;
        std::exception_ptr failure;
        bool ended = false;
    };
    static std::vector<std::size_t> take(Shared& shared);
    static void run(Shared& shared);

    std::shared_ptr<Shared> shared_;
    std::vector<std::thread> pool_;
};

}  // namespace swirl::apps
