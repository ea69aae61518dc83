// SPDX-License-Identifier: MIT
// A display for VTK, which on Debian draws through X11 only and aborts without one.
#pragma once
#include <sys/types.h>

namespace gno::viz {

/// Makes sure that DISPLAY names a display that answers: the user's when there is one, else an Xvfb of our own that ends with this object (or with
/// the process, however that ends). Make one before the first call into VTK's rendering, on the main thread, and keep it until the last.
class Display {
public:
    /// Throws InputError: there is no display, and Xvfb is not installed or does not start.
    Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;
    ~Display();

    /// True: there is a screen that somebody may look at (--interactive makes sense).
    [[nodiscard]] bool isUsers() const { return server_ < 0; }

private:
    bool connect();
    void startServer();
    void* connection_ =
        nullptr;  ///< Xlib's Display; kept open, because a server may reset, and refuse others for a moment, when its last client leaves
    pid_t server_ = -1;
};

}  // namespace gno::viz
