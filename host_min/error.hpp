// SPDX-License-Identifier: MIT
// Errors that reach the user. `main` prints their text as one line and returns their exit code, in every build type.
#pragma once
#include <stdexcept>
#include <string>

namespace gno::host {

/// Bad input, or a missing device or feature: exit code 2. The text says what is wrong and what to do, in one line.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Anything else that stops the work (a full disk, a failing driver, an interrupt): exit code 1.
class WorkError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The device or the machine has no memory left for this much: a smaller piece of work may still go.
class MemoryError : public WorkError {
public:
    using WorkError::WorkError;
};

}  // namespace gno::host
