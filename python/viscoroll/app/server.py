"""Server of the page, only for browsers of this user on this machine.

Addresses begin with a random token, which the relative links of the page repeat. The server rejects requests without
the token, whether they come from a program of another user or from a page of another site. The token does not appear in
the list of processes: the browser is started with the name of a private file, which redirects to the page.
"""

from __future__ import annotations

import contextlib
import io
import json
import re
import secrets
import select
import shutil
import socket
import sys
import tempfile
import threading
import time
import webbrowser
from html import escape
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .answer import answer, scalars
from .case_text import opened
from .history import history_answer, history_scalars
from .temperature import temperature_answer

if TYPE_CHECKING:
    from collections.abc import Callable

__all__ = ["PageServer", "serve"]

_HOST = "127.0.0.1"

#: Media types of the files of the page, by suffix.
_TYPES = {".html": "text/html", ".css": "text/css", ".js": "text/javascript"}

#: Largest request [bytes]. A case has some hundred characters, a measured curve in it some ten thousand.
_LONGEST_REQUEST = 1_000_000

#: Pattern of the length of a request body. Python does not convert numbers of thousands of digits.
_LENGTH = re.compile("[0-9]{1,18}")

#: Largest time for a whole request to arrive, and for an answer to be received [s]. A local browser needs milliseconds.
_LONGEST_TRANSFER = 10.0

#: Largest number of simultaneous connections. A browser opens up to six for each window.
_MAX_CONNECTIONS = 32

#: Script element of the page with the solver and the initial case.
_START = '<script type="application/json" id="start">{}</script>'
_NO_SOLVER = _START.format('{"solver": "none"}')

#: HTTP headers of every answer.
_HEADERS = {
    "Cache-Control": "no-store",
    "Content-Security-Policy": (
        "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; "
        "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    ),
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
}

_REDIRECT = """<!doctype html>
<meta charset="utf-8" />
<meta http-equiv="refresh" content="0; url={address}" />
<title>viscoroll</title>
<p><a href="{address}">Open the page</a></p>
"""


class _Disconnected(Exception):  # noqa: N818  (not an error: the answer is no longer wanted)
    """Raised during a solve if the browser has closed the connection or the server stops."""


class PageServer(ThreadingHTTPServer):
    """HTTP server of one page.

    Parameters
    ----------
    case : dict, optional
        Tables of the initial case of the page.
    port : int, default 0
        Port; 0 selects a free one.

    Attributes
    ----------
    address : str
        Address of the page, with the token.
    """

    daemon_threads = False  # server_close waits for them

    def __init__(self, case: dict[str, Any] | None = None, *, port: int = 0) -> None:
        super().__init__((_HOST, port), _Handler)
        self.token = secrets.token_urlsafe(16)
        self.address = f"http://{_HOST}:{self.server_port}/{self.token}/"
        self.hosts = {f"{name}:{self.server_port}" for name in (_HOST, "localhost")}
        self.files = _page_files(case)
        self._open: set[socket.socket] = set()
        self._free = threading.BoundedSemaphore(_MAX_CONNECTIONS)
        self._private: Path | None = None

    def redirect_file(self) -> Path:
        """Write a file that redirects a browser to the page; only this user can read it.

        The file is removed when the page is first sent, at the latest when the server closes.
        """
        self._private = Path(tempfile.mkdtemp(prefix="viscoroll-"))  # mode 0700
        path = self._private / "page.html"
        path.touch(mode=0o600)
        path.write_text(_REDIRECT.format(address=escape(self.address)), encoding="utf-8")
        return path

    def remove_redirect_file(self) -> None:
        """Remove the file of `redirect_file`, if there is one."""
        private, self._private = self._private, None
        if private is not None:
            shutil.rmtree(private, ignore_errors=True)

    def process_request(self, request: Any, client_address: Any) -> None:
        """Answer a request in a thread of its own, or reject it if there are too many connections."""
        if self._free.acquire(blocking=False):
            super().process_request(request, client_address)
            return
        with contextlib.suppress(OSError):
            request.sendall(b"HTTP/1.0 503 Service Unavailable\r\nContent-Length: 0\r\n\r\n")
        self.shutdown_request(request)

    def process_request_thread(self, request: Any, client_address: Any) -> None:
        """Answer a request; until then, the set of open connections contains its connection."""
        self._open.add(request)
        try:
            super().process_request_thread(request, client_address)
        finally:
            self._open.discard(request)
            self._free.release()

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Print errors, except those of browsers that close the connection or respond too late."""
        if not isinstance(sys.exception(), ConnectionError | TimeoutError):
            super().handle_error(request, client_address)

    def server_close(self) -> None:
        """Close all connections, which ends their solves, and the server."""
        self.remove_redirect_file()
        for connection in list(self._open):
            with contextlib.suppress(OSError):
                connection.shutdown(socket.SHUT_RDWR)
        super().server_close()


def serve(case: dict[str, Any] | None = None, *, browser: bool = True, tell: Callable[[str], object] = print) -> None:
    """Serve the page until Ctrl-C.

    Parameters
    ----------
    case : dict, optional
        Tables of the initial case of the page.
    browser : bool, default True
        Whether to open the page in a browser.
    tell : callable, default print
        Called with a line that contains the address.
    """
    with PageServer(case) as server:
        tell(f"{server.address}  (Ctrl-C ends it)")
        if browser:
            webbrowser.open(server.redirect_file().as_uri())
        with contextlib.suppress(KeyboardInterrupt):
            server.serve_forever(poll_interval=0.1)


def _page_files(case: dict[str, Any] | None) -> dict[str, tuple[str, bytes]]:
    """Return media type and content of the files of the page, by name."""
    folder = resources.files(__package__).joinpath("page")
    files = {
        file.name: (_TYPES[suffix], file.read_bytes())
        for file in folder.iterdir()
        if (suffix := file.name[file.name.rfind(".") :]) in _TYPES
    }
    kind, page = files.pop("index.html")
    # "</" would end the script element.
    start = json.dumps({"solver": "native", "case": case}).replace("</", "<\\/")
    return files | {"": (kind, page.decode().replace(_NO_SOLVER, _START.format(start)).encode())}


class _TimedReader(io.RawIOBase):
    """Reader of a connection, with one deadline for all reads together."""

    def __init__(self, connection: socket.socket) -> None:
        self._connection = connection
        self._deadline = time.monotonic() + _LONGEST_TRANSFER

    def readable(self) -> bool:
        """Return True."""
        return True

    def readinto(self, buffer: Any) -> int:
        """Read what has arrived; raise a TimeoutError after the deadline."""
        left = self._deadline - time.monotonic()
        if left <= 0.0:
            raise TimeoutError("the request did not arrive in time")
        self._connection.settimeout(left)
        try:
            return self._connection.recv_into(buffer)
        finally:
            self._connection.settimeout(_LONGEST_TRANSFER)


class _Handler(BaseHTTPRequestHandler):
    """Handler of one request."""

    server: PageServer
    timeout = _LONGEST_TRANSFER  # time for an answer to be received [s]

    def setup(self) -> None:
        """Read the request with a deadline."""
        super().setup()
        self.rfile = io.BufferedReader(_TimedReader(self.connection))

    def do_GET(self) -> None:
        """Send a file of the page."""
        name = self._name()
        if name is None:
            return
        if name not in self.server.files:
            self._refuse(HTTPStatus.NOT_FOUND)
            return
        self._send(*self.server.files[name])
        if not name:
            self.server.remove_redirect_file()

    def do_POST(self) -> None:
        """Send the answer to a request, the case of a case file, or a table of scalars."""
        name = self._name()
        if name is None:
            return
        if name not in ("solve", "roll", "temperature", "open", "scalars", "history_scalars"):
            self._refuse(HTTPStatus.NOT_FOUND)
            return
        body = self._body()
        if body is None:
            return
        if name in ("scalars", "history_scalars"):
            self._send_json(scalars() if name == "scalars" else history_scalars())
            return
        try:
            request = _read_json(body)
        except (ValueError, RecursionError):
            self._refuse(HTTPStatus.BAD_REQUEST)
            return
        if name == "open":
            self._send_json(opened(request))
            return
        try:
            if name == "roll":
                self._send_history(request)
                return
            found = temperature_answer if name == "temperature" else answer
            self._send_json(found(request, progress=self._stop_if_closed))
        except _Disconnected:
            return

    def _name(self) -> str | None:
        """Return the name after the token; reject requests without token, or from another site, and return None."""
        token, slash, name = self.path.partition("?")[0].removeprefix("/").partition("/")
        hosts, origins = self.headers.get_all("Host", []), self.headers.get_all("Origin", [])
        is_here = len(hosts) == 1 and hosts[0] in self.server.hosts  # else another site's name resolves to this machine
        is_own = all(origin == f"http://{hosts[0]}" for origin in origins) if is_here else False
        is_known = secrets.compare_digest(token.encode("utf-8", "replace"), self.server.token.encode())
        if not (slash and is_here and is_own and is_known):
            self._refuse(HTTPStatus.FORBIDDEN)
            return None
        return name

    def _body(self) -> bytes | None:
        """Return the body of a request; reject requests without a valid length, and return None."""
        lengths = self.headers.get_all("Content-Length", [])
        if not lengths:
            self._refuse(HTTPStatus.LENGTH_REQUIRED)
            return None
        if len(lengths) > 1 or not _LENGTH.fullmatch(lengths[0]) or "Transfer-Encoding" in self.headers:
            self._refuse(HTTPStatus.BAD_REQUEST)
            return None
        length = int(lengths[0])
        if length > _LONGEST_REQUEST:
            self._refuse(HTTPStatus.REQUEST_ENTITY_TOO_LARGE)
            return None
        body = self.rfile.read(length)
        if len(body) < length:
            self._refuse(HTTPStatus.BAD_REQUEST)
            return None
        return body

    def _stop_if_closed(self, _stage: str, _fraction: float) -> None:
        """Stop a solve, as its progress function, if the browser has closed the connection."""
        if self._is_closed():
            raise _Disconnected

    def _is_closed(self) -> bool:
        """Return whether the browser has closed the connection: it is readable, but there is nothing to read."""
        try:
            readable = select.select([self.connection], [], [], 0.0)[0]
            return bool(readable) and not self.connection.recv(1, socket.MSG_PEEK)
        except OSError:
            return True

    def _send_history(self, request: object) -> None:
        """Send a history as it is computed: a line of JSON for each part, and a last one for the answer."""

        def send(**line: object) -> None:
            self.wfile.write(json.dumps(line, allow_nan=False).encode() + b"\n")

        self._send_head("application/x-ndjson", HTTPStatus.OK)
        found = history_answer(request, receive=lambda part: send(part=part), progress=self._stop_if_closed)
        send(answer=found)

    def _send_json(self, content: object) -> None:
        self._send("application/json", json.dumps(content, allow_nan=False).encode())

    def _refuse(self, status: HTTPStatus) -> None:
        self._send("text/plain", status.phrase.encode(), status=status)

    def _send(self, kind: str, content: bytes, *, status: HTTPStatus = HTTPStatus.OK) -> None:
        self._send_head(kind, status, {"Content-Length": str(len(content))})
        self.wfile.write(content)

    def _send_head(self, kind: str, status: HTTPStatus, more: dict[str, str] | None = None) -> None:
        self.send_response(status)
        for name, value in ({"Content-Type": f"{kind}; charset=utf-8"} | (more or {}) | _HEADERS).items():
            self.send_header(name, value)
        self.end_headers()

    def send_error(self, code: int, message: str | None = None, explain: str | None = None) -> None:  # noqa: ARG002
        """Reject requests that are not valid HTTP like all others, without quoting them."""
        self.request_version = self.protocol_version  # an answer to an unknown version would have no headers
        self._refuse(HTTPStatus(code))

    def version_string(self) -> str:
        """Return the name of the server without versions."""
        return "viscoroll"

    def log_message(self, *_: object) -> None:
        """Print nothing: requests are not logged on the terminal."""


def _read_json(body: bytes) -> Any:
    """Return the content of the body of a request.

    Raises
    ------
    ValueError
        If the body is not JSON in UTF-8, or contains NaN, infinite numbers, integers of thousands of digits or lone
        surrogates.
    RecursionError
        If the content is nested too deeply.
    """

    def refused(constant: str) -> Any:
        raise ValueError(f"{constant} is not JSON")

    content = json.loads(body.decode(), parse_constant=refused)
    json.dumps(content, ensure_ascii=False).encode()  # raises a UnicodeEncodeError for lone surrogates
    return content
