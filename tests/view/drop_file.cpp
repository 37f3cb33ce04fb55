// Drops a file on a window as a file manager does: the XDND protocol, version 5 (freedesktop.org). xdotool cannot.
//
// usage: drop_file WINDOW FILE    the window's number and an absolute path; exit code 1: it was not taken
#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

constexpr long kVersion = 5;

struct Drop
{
    Display* display = XOpenDisplay(nullptr);
    Window source = 0, target = 0;
    std::string uris;

    Atom atom(const char* name) const { return XInternAtom(display, name, False); }

    void send(const char* type, long second, long third, long fourth, long fifth) const
    {
        XEvent event = {};
        event.xclient.type = ClientMessage;
        event.xclient.window = target;
        event.xclient.message_type = atom(type);
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(source);
        event.xclient.data.l[1] = second;
        event.xclient.data.l[2] = third;
        event.xclient.data.l[3] = fourth;
        event.xclient.data.l[4] = fifth;
        XSendEvent(display, target, False, NoEventMask, &event);
        XFlush(display);
    }

    // Hands the list of files over to who asks for it.
    void answer(const XSelectionRequestEvent& request) const
    {
        XChangeProperty(display, request.requestor, request.property, request.target, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(uris.data()), static_cast<int>(uris.size()));
        XEvent reply = {};
        reply.xselection.type = SelectionNotify;
        reply.xselection.requestor = request.requestor;
        reply.xselection.selection = request.selection;
        reply.xselection.target = request.target;
        reply.xselection.property = request.property;
        reply.xselection.time = request.time;
        XSendEvent(display, request.requestor, False, NoEventMask, &reply);
        XFlush(display);
    }

    // The window's answer of this kind; whether it says yes in its second word (GLFW puts a count of bytes there).
    bool awaitAnswer(const char* type) const
    {
        for (XEvent event;;) {
            XNextEvent(display, &event);
            if (event.type == SelectionRequest)
                answer(event.xselectionrequest);
            else if (event.type == ClientMessage && event.xclient.message_type == atom(type))
                return event.xclient.data.l[1] != 0;
        }
    }

    bool run() const
    {
        XSetSelectionOwner(display, atom("XdndSelection"), source, CurrentTime);
        send("XdndEnter", kVersion << 24, static_cast<long>(atom("text/uri-list")), 0, 0);
        send("XdndPosition", 0, (100 << 16) | 100, CurrentTime, static_cast<long>(atom("XdndActionCopy")));
        if (!awaitAnswer("XdndStatus"))
            return false;
        send("XdndDrop", 0, CurrentTime, 0, 0);
        return awaitAnswer("XdndFinished");
    }
};

} // namespace

int main(int argc, char** argv)
{
    Drop drop;
    if (argc != 3 || !drop.display) {
        std::fprintf(stderr, "usage: drop_file WINDOW FILE, with DISPLAY set\n");
        return 2;
    }
    drop.source = XCreateSimpleWindow(drop.display, DefaultRootWindow(drop.display), 0, 0, 1, 1, 0, 0, 0);
    drop.target = std::strtoul(argv[1], nullptr, 0);
    drop.uris = "file://" + std::string(argv[2]) + "\r\n";
    return drop.run() ? 0 : 1;
}
