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

/// A limit of the device that this frame passes for one technique; another technique, or a smaller frame, may go. Exit code 2.
class LimitError : public InputError {
public:
    using InputError::InputError;
};

/// Anything else that stops the work: exit code 1, but for what derives from RoomError.
class WorkError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// No room for this much, on the disk or in memory: a smaller piece of work may still go. Exit code 2.
class RoomError : public WorkError {
public:
    using WorkError::WorkError;
};

/// Of the device or the machine.
class MemoryError : public RoomError {
public:
    using RoomError::RoomError;
};

/// The device is lost: nothing more can be asked of it in this process.
class DeviceLost : public WorkError {
public:
    using WorkError::WorkError;
};

/// Ctrl-C or SIGTERM: whatever is half done is left out.
class Interrupted : public WorkError {
public:
    using WorkError::WorkError;
};

}  // namespace gno::host
