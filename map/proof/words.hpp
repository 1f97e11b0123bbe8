// Reasons in words.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <string>

namespace swirl::proof {

/// By printf's format; what is longer than 400 characters is cut.
[[gnu::format(printf, 1, 2)]] inline std::string words(const char* format, ...) {
    char text[400];
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return text;
}

}  // namespace swirl::proof
