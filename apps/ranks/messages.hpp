// What ranks tell one another, as bytes: its kind, then numbers of pieces, or results, or words. All ranks run the same
// program on machines of one kind.
#pragma once

#include "apps/ranks/workers.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace swirl::apps {

enum class MessageKind : unsigned char {
    wants_work,  ///< to rank 0: pieces are running out; with the name of what is done with them
    results,     ///< to rank 0
    alive,       ///< to rank 0, when there is nothing else to tell
    refused,     ///< to rank 0: why that rank can't work
    work,        ///< from rank 0: numbers of pieces
    end,         ///< from rank 0
    gone,        ///< to rank 0, the last: its answer to the end
    all_gone,    ///< from rank 0, the last: every rank has answered, so that all can leave MPI together
    some_lost    ///< from rank 0, the last: one has not, and MPI_Finalize would wait for it
};

std::vector<std::byte> message_of(MessageKind kind, std::string_view words = {});
std::vector<std::byte> message_of(std::span<const std::size_t> pieces);
std::vector<std::byte> message_of(const std::vector<PieceResult>& results);

MessageKind message_kind_of(std::span<const std::byte> message);
std::string words_in(std::span<const std::byte> message);
std::vector<std::size_t> pieces_in(std::span<const std::byte> message);
std::vector<PieceResult> results_in(std::span<const std::byte> message);

}  // namespace swirl::apps
