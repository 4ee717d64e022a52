#pragma once
// Whether a test runs under AddressSanitizer: it keeps memory that is given back, and lets no memory be locked.

namespace leadscrew::testing_support {

inline constexpr bool is_sanitized =
#if defined(__SANITIZE_ADDRESS__)  // as GCC tells it
    true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)  // as clang tells it
    true;
#else
    false;
#endif
#else
    false;
#endif

}  // namespace leadscrew::testing_support
