// Pieces of work over all ranks: handed out as they are wanted, their results kept by rank 0.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/ranks/ranks.hpp"
#include "apps/ranks/workers.hpp"

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace swirl::apps {

/// What is done with pieces, and a name for it that ranks have in common which do the same.
struct NamedWork {
    std::string name;
    PieceWork work;
    std::size_t most_together = 1;  ///< so many pieces at most are worked at together
};

/// Rank 0's part, from its beginning to its end, when the other ranks end, too.
class HandOut {
public:
    HandOut(Ranks& ranks, bool quiet)
        : ranks_(ranks), quiet_(quiet), others_(static_cast<std::size_t>(ranks.count())) {}
    /// Tells the others that this is the end, and waits for their answer: seconds at most.
    ~HandOut();
    HandOut(const HandOut&) = delete;
    HandOut& operator=(const HandOut&) = delete;

    /// Has these pieces done, by the other ranks, which serve() with the same `work`, and on so many threads of this
    /// one (0: all); keeps each result once, in the order in which they come. A rank of which nothing is heard for half
    /// a minute is reported, and its pieces are done by others; so is one whose work has another name. May be called
    /// again.
    /// @return false if it was interrupted. Exceptions of a piece on this rank are passed on.
    bool run(std::span<const std::size_t> pieces, int threads, const NamedWork& work, Progress& progress,
             const std::function<void(const PieceResult&)>& keep);

private:
    using Clock = std::chrono::steady_clock;
    struct Other {
        bool wants_work = false;
        bool lost = false;  ///< and not heard of since
        bool is_reported = false;
        bool has_gone = false;
        std::set<std::size_t> has;  ///< pieces that it was given and has not done
        Clock::time_point heard = Clock::now();
    };

    std::vector<std::size_t> take(std::size_t most_together);
    void hand_to_those_who_want(Workers& own, std::size_t most_together);
    void read(const Message& message, std::string_view name);
    void leave_out(int rank, std::string_view why);
    void look_for_lost_ranks();

    Ranks& ranks_;
    bool quiet_;
    std::vector<Other> others_;  ///< by rank; that of rank 0 is not used
    std::deque<std::size_t> left_;
    std::vector<PieceResult> results_;
};

/// A name of what these settings ask of this program.
std::string name_of_work(const Settings& settings);

/// A command on all ranks: rank 0 does what `lead` does, every other the work that `plan` gives, until rank 0 says that
/// it is the end. (Where rank 0 dies, its launcher ends all.) Where `plan` throws, rank 0 learns why that rank can't
/// work.
///   threads  of this rank; 0: all
/// @return the exit code
int on_all_ranks(bool quiet, int threads, const std::function<NamedWork()>& plan,
                 const std::function<int(HandOut&)>& lead);

}  // namespace swirl::apps
