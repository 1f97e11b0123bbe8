// What a fuzzer looks for beside crashes: promises that are not kept, and errors that the program does not name.
#pragma once

#include "apps/command_line/errors.hpp"
#include "apps/record/record_error.hpp"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace swirl::tests::fuzz {

/// Ends the process where what was promised is not so: the fuzzer keeps the input.
inline void require(bool kept, const char* promise) {
    if (kept) return;
    std::fprintf(stderr, "not kept: %s\n", promise);
    std::abort();
}

/// Runs `read`. An answer and a refusal are both good: true, false. Whatever else is thrown leaves through here and
/// ends the process, as what apps/main.cpp calls unexpected.
template <class Read>
bool answers(const Read& read) {
    try {
        read();
        return true;
    } catch (const apps::BadInput& refusal) {
        require(*refusal.what() != '\0', "a refusal says why");
    } catch (const apps::RecordError& refusal) {
        require(*refusal.what() != '\0', "a refusal says why");
    } catch (const std::invalid_argument& refusal) {  // of the libraries, a range
        require(*refusal.what() != '\0', "a refusal says why");
    }
    return false;
}

}  // namespace swirl::tests::fuzz
