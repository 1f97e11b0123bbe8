#include "apps/ranks/messages.hpp"

#include <cstring>

namespace swirl::apps {

namespace {

/// A kind, and room for so many bytes.
std::vector<std::byte> begin(MessageKind kind, std::size_t size) {
    std::vector<std::byte> message(1 + size);
    message.front() = static_cast<std::byte>(kind);
    return message;
}

/// Puts bytes at `place`, and gives the place after them.
std::size_t put(std::vector<std::byte>& message, std::size_t place, const void* bytes, std::size_t size) {
    if (size > 0) std::memcpy(message.data() + place, bytes, size);
    return place + size;
}

std::size_t take_number(std::span<const std::byte>& rest) {
    std::size_t number = 0;
    std::memcpy(&number, rest.data(), sizeof number);
    rest = rest.subspan(sizeof number);
    return number;
}

}  // namespace

std::vector<std::byte> message_of(MessageKind kind, std::string_view words) {
    auto message = begin(kind, words.size());
    put(message, 1, words.data(), words.size());
    return message;
}

std::vector<std::byte> message_of(std::span<const std::size_t> pieces) {
    auto message = begin(MessageKind::work, pieces.size_bytes());
    put(message, 1, pieces.data(), pieces.size_bytes());
    return message;
}

std::vector<std::byte> message_of(const std::vector<PieceResult>& results) {
    std::size_t size = 0;
    for (const auto& result : results) size += 2 * sizeof(std::size_t) + result.bytes.size();
    auto message = begin(MessageKind::results, size);
    std::size_t place = 1;
    for (const auto& [piece, bytes] : results) {
        for (const std::size_t number : {piece, bytes.size()}) place = put(message, place, &number, sizeof number);
        place = put(message, place, bytes.data(), bytes.size());
    }
    return message;
}

MessageKind message_kind_of(std::span<const std::byte> message) {
    return static_cast<MessageKind>(message.front());
}

std::string words_in(std::span<const std::byte> message) {
    return {reinterpret_cast<const char*>(message.data()) + 1, message.size() - 1};
}

std::vector<std::size_t> pieces_in(std::span<const std::byte> message) {
    std::vector<std::size_t> pieces((message.size() - 1) / sizeof(std::size_t));
    if (!pieces.empty()) std::memcpy(pieces.data(), message.data() + 1, pieces.size() * sizeof(std::size_t));
    return pieces;
}

std::vector<PieceResult> results_in(std::span<const std::byte> message) {
    std::vector<PieceResult> results;
    for (auto rest = message.subspan(1); !rest.empty();) {
        const std::size_t piece = take_number(rest);
        const std::size_t size = take_number(rest);
        results.push_back({piece, {rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(size)}});
        rest = rest.subspan(size);
    }
    return results;
}

}  // namespace swirl::apps
