#include "apps/ranks/hand_out.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/ranks/messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <utility>

namespace swirl::apps {

namespace {

using namespace std::chrono_literals;

// Between two polls for messages and results. Work is asked for while there still is some, so that nobody waits for a
// poll; a poll of MPI itself takes some 30 µs.
constexpr auto poll_interval = 2ms;
constexpr auto silence_limit = 30s;  // a rank says once a second that it is there
constexpr auto heartbeat = 1s;
constexpr auto shutdown_grace = 10s;
constexpr std::size_t most_at_once = 1024;
constexpr std::size_t longest_result = std::size_t{1} << 30;  // a message of MPI has up to 2³¹ − 1 bytes
constexpr std::size_t most_bytes_at_once = std::size_t{1} << 20;

/// Answers rank 0's end, and leaves MPI with the others only if none of them was lost.
void shut_down(Ranks& ranks) {
    ranks.send(0, message_of(MessageKind::gone));
    const auto limit = std::chrono::steady_clock::now() + 2 * shutdown_grace;
    while (!is_interrupted()) {
        const bool too_late = std::chrono::steady_clock::now() >= limit;  // a suspended process polls once more
        if (const auto message = ranks.receive()) {
            if (message_kind_of(message->bytes) == MessageKind::all_gone) return;
            if (message_kind_of(message->bytes) == MessageKind::some_lost) break;
        } else if (too_late) {
            break;
        } else {
            std::this_thread::sleep_for(poll_interval);
        }
    }
    ranks.lose();
}

/// Tells rank 0 why this rank can't work, and waits for its end.
void refuse_to_serve(Ranks& ranks, const std::string& why) {
    constexpr std::size_t longest = 1000;
    ranks.send(0, message_of(MessageKind::refused, why.substr(0, longest)));
    while (!is_interrupted()) {
        if (const auto message = ranks.receive(); message && message_kind_of(message->bytes) == MessageKind::end)
            return shut_down(ranks);
        std::this_thread::sleep_for(poll_interval);
    }
}

/// Works until rank 0 says that it is the end.
void serve(Ranks& ranks, int threads, const NamedWork& work) {
    Workers workers(threads, work.most_together, work.work);
    bool asked = false;
    auto last_message = std::chrono::steady_clock::now() - heartbeat;
    const auto say = [&](const std::vector<std::byte>& message) {
        ranks.send(0, message);
        last_message = std::chrono::steady_clock::now();
    };
    while (!is_interrupted()) {
        std::vector<PieceResult> some;
        std::size_t bytes = 0;
        for (PieceResult& result : workers.results()) {
            if (result.bytes.size() > longest_result)
                return refuse_to_serve(ranks, fmt::format("a result of {} bytes is outside its range: up to {}",
                                                          result.bytes.size(), longest_result));
            bytes += result.bytes.size();
            some.push_back(std::move(result));
            if (bytes < most_bytes_at_once) continue;
            say(message_of(std::exchange(some, {})));
            bytes = 0;
        }
        if (!some.empty()) say(message_of(some));
        while (const auto message = ranks.receive()) {
            if (message_kind_of(message->bytes) == MessageKind::end) return shut_down(ranks);
            workers.add(pieces_in(message->bytes));
            asked = false;
        }
        if (!asked && workers.wants_more()) {
            say(message_of(MessageKind::wants_work, work.name));
            asked = true;
        }
        if (std::chrono::steady_clock::now() - last_message >= heartbeat) say(message_of(MessageKind::alive));
        std::this_thread::sleep_for(poll_interval);
    }
}

int take_part(Ranks& ranks, int threads, const std::function<NamedWork()>& plan) {
    note_interruptions();
    try {
        serve(ranks, threads, plan());
    } catch (const std::exception& error) {
        refuse_to_serve(ranks, error.what());
    }
    return is_interrupted() ? exit_interrupted : exit_done;
}

}  // namespace

HandOut::~HandOut() {
    for (int to = 1; to < ranks_.count(); ++to) ranks_.send(to, message_of(MessageKind::end));
    const auto limit = Clock::now() + shutdown_grace;
    const auto stays = [](const Other& other) { return !other.lost && !other.has_gone; };
    while (std::any_of(others_.begin() + 1, others_.end(), stays) && Clock::now() < limit && !is_interrupted()) {
        while (const auto message = ranks_.receive()) {
            Other& other = others_[static_cast<std::size_t>(message->from)];
            other.lost = false;
            if (message_kind_of(message->bytes) == MessageKind::gone) other.has_gone = true;
        }
        std::this_thread::sleep_for(poll_interval);
    }
    const auto went = [](const Other& other) { return other.has_gone; };
    const bool all_went = std::all_of(others_.begin() + 1, others_.end(), went);
    for (int to = 1; to < ranks_.count(); ++to)
        ranks_.send(to, message_of(all_went ? MessageKind::all_gone : MessageKind::some_lost));
    if (!all_went) ranks_.lose();
}

/// The next pieces: few when few are left, so that all ranks end together, but as many as go together while there are
/// as many for every rank; all where there is one.
std::vector<std::size_t> HandOut::take(std::size_t most_together) {
    if (others_.size() == 1) {
        const auto all = std::exchange(left_, {});
        return {all.begin(), all.end()};
    }
    const std::size_t each = left_.size() / others_.size();
    const std::size_t share = std::max(each / 4, std::min(each, most_together));
    const std::size_t count = std::min(left_.size(), std::clamp<std::size_t>(share, 1, most_at_once));
    const auto end = left_.begin() + static_cast<std::ptrdiff_t>(count);
    std::vector<std::size_t> taken(left_.begin(), end);
    left_.erase(left_.begin(), end);
    return taken;
}

void HandOut::hand_to_those_who_want(Workers& own, std::size_t most_together) {
    if (!left_.empty() && own.wants_more()) own.add(take(most_together));
    for (int to = 1; to < ranks_.count(); ++to) {
        Other& other = others_[static_cast<std::size_t>(to)];
        if (!other.wants_work || other.lost || left_.empty()) continue;
        const auto pieces = take(most_together);
        other.wants_work = false;
        other.has.insert(pieces.begin(), pieces.end());
        ranks_.send(to, message_of(pieces));
    }
}

void HandOut::read(const Message& message, std::string_view name) {
    Other& other = others_[static_cast<std::size_t>(message.from)];
    other.heard = Clock::now();
    other.lost = false;
    switch (message_kind_of(message.bytes)) {
        case MessageKind::wants_work:
            if (words_in(message.bytes) != name)
                return leave_out(message.from,
                                 "it would do other work: other options or files there, or another swirl");
            other.wants_work = true;
            break;
        case MessageKind::results:
            for (PieceResult& result : results_in(message.bytes)) {
                other.has.erase(result.piece);
                results_.push_back(std::move(result));
            }
            break;
        case MessageKind::refused:
            other.wants_work = false;
            leave_out(message.from, words_in(message.bytes));
            break;
        case MessageKind::alive:
        case MessageKind::work:
        case MessageKind::end:
        case MessageKind::gone:
        case MessageKind::all_gone:
        case MessageKind::some_lost:
            break;
    }
}

/// What it has not done is done by others.
void HandOut::leave_out(int rank, std::string_view why) {
    Other& other = others_[static_cast<std::size_t>(rank)];
    if (!quiet_ && !other.is_reported)
        report(fmt::format("swirl: rank {} takes no part, and its {} unfinished runs are done by others: {}", rank,
                           other.has.size(), why));
    other.is_reported = true;
    left_.insert(left_.end(), other.has.begin(), other.has.end());
    other.has.clear();
}

void HandOut::look_for_lost_ranks() {
    for (int from = 1; from < ranks_.count(); ++from) {
        Other& other = others_[static_cast<std::size_t>(from)];
        if (other.lost || other.has.empty() || Clock::now() - other.heard < silence_limit) continue;
        leave_out(from, fmt::format("nothing was heard of it for {} s", std::chrono::seconds(silence_limit).count()));
        other.lost = true;
    }
}

bool HandOut::run(std::span<const std::size_t> pieces, int threads, const NamedWork& work, Progress& progress,
                  const std::function<void(const PieceResult&)>& keep) {
    Workers own(threads, work.most_together, work.work);
    left_.assign(pieces.begin(), pieces.end());
    for (Other& other : others_) other.heard = Clock::now();
    std::vector<char> unfinished(pieces.empty() ? 0 : *std::max_element(pieces.begin(), pieces.end()) + 1, 0);
    for (const std::size_t piece : pieces) unfinished[piece] = 1;
    std::size_t finished = 0;
    while (finished < pieces.size()) {
        if (is_interrupted()) return false;
        while (const auto message = ranks_.receive()) read(*message, work.name);
        look_for_lost_ranks();
        for (PieceResult& result : own.results()) results_.push_back(std::move(result));
        for (const PieceResult& result : std::exchange(results_, {})) {
            if (result.piece >= unfinished.size() || !unfinished[result.piece]) continue;  // of one believed lost
            unfinished[result.piece] = 0;
            keep(result);
            progress.at(static_cast<double>(++finished));
        }
        hand_to_those_who_want(own, work.most_together);
        std::this_thread::sleep_for(poll_interval);
    }
    return true;
}

std::string name_of_work(const Settings& settings) {
    const std::string all = fmt::format("{} ({})\n{}", version(), instruction_set(), settings_text(settings));
    return fmt::format("{:016x}", std::hash<std::string>()(all));
}

int on_all_ranks(bool quiet, int threads, const std::function<NamedWork()>& plan,
                 const std::function<int(HandOut&)>& lead) {
    Ranks ranks;
    if (ranks.number() > 0) return take_part(ranks, threads, plan);
    HandOut hand_out(ranks, quiet);
    return lead(hand_out);
}

}  // namespace swirl::apps
