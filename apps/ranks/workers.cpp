#include "apps/ranks/workers.hpp"

#include "apps/command_line/interruption.hpp"

#include <tbb/task_arena.h>

#include <algorithm>
#include <utility>

namespace swirl::apps {

Workers::Workers(int threads, std::size_t most_together, PieceWork work) : shared_(std::make_shared<Shared>()) {
    const int all = threads > 0 ? threads : tbb::this_task_arena::max_concurrency();
    shared_->work = std::move(work);
    shared_->threads = static_cast<std::size_t>(all);
    shared_->most_together = most_together;
    for (int i = 0; i < all; ++i) pool_.emplace_back([shared = shared_] { run(*shared); });
}

Workers::~Workers() {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->ended = true;
    }
    shared_->changed.notify_all();
    for (std::thread& thread : pool_) is_interrupted() ? thread.detach() : thread.join();
}

/// The next pieces: a thread's share of what waits.
std::vector<std::size_t> Workers::take(Shared& shared) {
    const std::size_t share = shared.waiting.size() / shared.threads;
    const auto end =
        shared.waiting.begin() + static_cast<std::ptrdiff_t>(std::clamp<std::size_t>(share, 1, shared.most_together));
    std::vector<std::size_t> taken(shared.waiting.begin(), end);
    shared.waiting.erase(shared.waiting.begin(), end);
    return taken;
}

void Workers::run(Shared& shared) {
    const auto keep = [&shared](PieceResult result) {
        const std::lock_guard lock(shared.mutex);
        shared.results.push_back(std::move(result));
    };
    std::unique_lock lock(shared.mutex);
    while (true) {
        shared.changed.wait(lock, [&] { return shared.ended || !shared.waiting.empty(); });
        if (shared.ended) return;
        const std::vector<std::size_t> pieces = take(shared);
        lock.unlock();
        std::exception_ptr failure;
        try {
            shared.work(pieces, keep);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        if (failure) shared.failure = failure;
    }
}

void Workers::add(std::span<const std::size_t> pieces) {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->waiting.insert(shared_->waiting.end(), pieces.begin(), pieces.end());
        shared_->last_added = pieces.size();
    }
    shared_->changed.notify_all();
}

bool Workers::wants_more() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->waiting.size() < std::max(shared_->threads, shared_->last_added / 2);
}

std::vector<PieceResult> Workers::results() {
    const std::lock_guard lock(shared_->mutex);
    if (shared_->failure) std::rethrow_exception(shared_->failure);
    return std::exchange(shared_->results, {});
}

}  // namespace swirl::apps
