#include "apps/ranks/messages.hpp"

#include <cstring>

namespace swirl::apps {

namespace {

void append(std::vector<std::byte>& message, const void* bytes, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(bytes);
    message.insert(message.end(), first, first + size);
}

std::size_t take_number(std::span<const std::byte>& rest) {
    std::size_t number = 0;
    std::memcpy(&number, rest.data(), sizeof number);
    rest = rest.subspan(sizeof number);
    return number;
}

}  // namespace

std::vector<std::byte> message_of(MessageKind kind, std::string_view words) {
    std::vector<std::byte> message{static_cast<std::byte>(kind)};
    append(message, words.data(), words.size());
    return message;
}

std::vector<std::byte> message_of(std::span<const std::size_t> pieces) {
    auto message = message_of(MessageKind::work);
    append(message, pieces.data(), pieces.size_bytes());
    return message;
}

std::vector<std::byte> message_of(const std::vector<PieceResult>& results) {
    auto message = message_of(MessageKind::results);
    for (const auto& [piece, bytes] : results) {
        for (const std::size_t number : {piece, bytes.size()}) append(message, &number, sizeof number);
        append(message, bytes.data(), bytes.size());
    }
    return message;
}

MessageKind kind_of(std::span<const std::byte> message) {
    return static_cast<MessageKind>(message.front());
}

std::string words_in(std::span<const std::byte> message) {
    return {reinterpret_cast<const char*>(message.data()) + 1, message.size() - 1};
}

std::vector<std::size_t> pieces_in(std::span<const std::byte> message) {
    std::vector<std::size_t> pieces((message.size() - 1) / sizeof(std::size_t));
    std::memcpy(pieces.data(), message.data() + 1, pieces.size() * sizeof(std::size_t));
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
