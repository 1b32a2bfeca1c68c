"""Serves the page to browsers of this machine, and nothing else.

Addresses begin with a random token, which the page's own links carry on, as they are relative: who does not know it is
refused, be it a program of another user or a page of another site.
"""

from __future__ import annotations

import contextlib
import json
import secrets
import select
import socket
import sys
import webbrowser
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from importlib import resources
from typing import TYPE_CHECKING, Any

from .answer import answer, scalars

if TYPE_CHECKING:
    from collections.abc import Callable

__all__ = ["PageServer", "serve"]

_HOST = "127.0.0.1"

#: Files of the page, by suffix; a folder of the package holds them.
_TYPES = {".html": "text/html", ".css": "text/css", ".js": "text/javascript"}

#: A case is some hundred characters, a measured curve in it some ten thousand [bytes].
_LONGEST_REQUEST = 1_000_000

#: What of the page says which solver it has, and what it begins with.
_START = '<script type="application/json" id="start">{}</script>'
_NO_SOLVER = _START.format('{"solver": "none"}')


class _Gone(Exception):  # noqa: N818  (no error: nobody waits for the answer)
    """Whoever asked has closed the window or asks something newer, or the server ends."""


class PageServer(ThreadingHTTPServer):
    """The server of one page.

    Parameters
    ----------
    case : dict, optional
        Tables of a case, with which the page begins.
    port : int, default 0
        0: any that is free.

    Attributes
    ----------
    address : str
        Where the page is, with the token.
    """

    daemon_threads = False  # they end before the server does

    def __init__(self, case: dict[str, Any] | None = None, *, port: int = 0) -> None:
        super().__init__((_HOST, port), _Handler)
        self.token = secrets.token_urlsafe(16)
        self.address = f"http://{_HOST}:{self.server_port}/{self.token}/"
        self.files = _page_files(case)
        self._open: set[socket.socket] = set()

    def process_request_thread(self, request: Any, client_address: Any) -> None:
        """Answer a request, known as one that is not answered yet."""
        self._open.add(request)
        try:
            super().process_request_thread(request, client_address)
        finally:
            self._open.discard(request)

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Say nothing of browsers that do not wait for an answer."""
        if not isinstance(sys.exception(), ConnectionError):
            super().handle_error(request, client_address)

    def server_close(self) -> None:
        """Cut what is open, by which solves end, and close."""
        for connection in list(self._open):
            with contextlib.suppress(OSError):
                connection.shutdown(socket.SHUT_RDWR)
        super().server_close()


def serve(case: dict[str, Any] | None = None, *, browser: bool = True, tell: Callable[[str], object] = print) -> None:
    """Serve the page until Ctrl-C.

    Parameters
    ----------
    case : dict, optional
        Tables of a case, with which the page begins.
    browser : bool
        Whether to open it.
    tell : callable
        Is given the address, on one line.
    """
    with PageServer(case) as server:
        tell(f"{server.address}  (Ctrl-C ends it)")
        if browser:
            webbrowser.open(server.address)
        with contextlib.suppress(KeyboardInterrupt):
            server.serve_forever(poll_interval=0.1)


def _page_files(case: dict[str, Any] | None) -> dict[str, tuple[str, bytes]]:
    """Return type and content of what is served, by name."""
    folder = resources.files(__package__).joinpath("page")
    files = {
        file.name: (_TYPES[suffix], file.read_bytes())
        for file in folder.iterdir()
        if (suffix := file.name[file.name.rfind(".") :]) in _TYPES
    }
    kind, page = files.pop("index.html")
    # In a script, "</" would end it.
    start = json.dumps({"solver": "native", "case": case}).replace("</", "<\\/")
    return files | {"": (kind, page.decode().replace(_NO_SOLVER, _START.format(start)).encode())}


class _Handler(BaseHTTPRequestHandler):
    """Answers one request."""

    server: PageServer
    timeout = 60.0  # of a connection that says nothing [s]

    def do_GET(self) -> None:
        """Send a file of the page."""
        name = self._name()
        if name is None:
            return
        if name not in self.server.files:
            self._refuse(HTTPStatus.NOT_FOUND)
            return
        self._send(*self.server.files[name])

    def do_POST(self) -> None:
        """Send the answer to a request, or the table of scalar results."""
        name = self._name()
        if name is None:
            return
        if name not in ("solve", "scalars"):
            self._refuse(HTTPStatus.NOT_FOUND)
            return
        length = self.headers.get("Content-Length", "")
        if not length.isdecimal() or int(length) > _LONGEST_REQUEST:
            self._refuse(HTTPStatus.REQUEST_ENTITY_TOO_LARGE)
            return
        body = self.rfile.read(int(length))
        if name == "scalars":
            self._send_json(scalars())
            return
        try:
            request = json.loads(body)
        except (ValueError, RecursionError):  # UnicodeDecodeError is one
            self._refuse(HTTPStatus.BAD_REQUEST)
            return
        try:
            self._send_json(answer(request, progress=self._wanted))
        except _Gone:
            return

    def _name(self) -> str | None:
        """Return what is asked for behind the token, or refuse."""
        token, slash, name = self.path.partition("?")[0].removeprefix("/").partition("/")
        if not slash or not secrets.compare_digest(token.encode(), self.server.token.encode()):
            self._refuse(HTTPStatus.FORBIDDEN)
            return None
        return name

    def _wanted(self, _stage: str, _fraction: float) -> None:
        """Stop a solve whose answer nobody will read."""
        if self._is_closed():
            raise _Gone

    def _is_closed(self) -> bool:
        """Whether the browser has closed the connection: it is readable, but there is nothing to read."""
        try:
            readable = select.select([self.connection], [], [], 0.0)[0]
            return bool(readable) and not self.connection.recv(1, socket.MSG_PEEK)
        except OSError:
            return True

    def _send_json(self, content: object) -> None:
        self._send("application/json", json.dumps(content, allow_nan=False).encode())

    def _refuse(self, status: HTTPStatus) -> None:
        self._send("text/plain", status.phrase.encode(), status=status)

    def _send(self, kind: str, content: bytes, *, status: HTTPStatus = HTTPStatus.OK) -> None:
        self.send_response(status)
        self.send_header("Content-Type", f"{kind}; charset=utf-8")
        self.send_header("Content-Length", str(len(content)))
        self.send_header("Cache-Control", "no-store")
        self.send_header("Referrer-Policy", "no-referrer")
        self.send_header("X-Content-Type-Options", "nosniff")
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, *_: object) -> None:
        """Say nothing: the terminal is the user's."""
