"""The server of the page: access by the token, served files, and the end of the server."""

from __future__ import annotations

import http.client
import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
import tomllib
from contextlib import closing

import pytest
from shared_cases import command
from viscoroll.app import answer, scalars
from viscoroll.app.temperature import temperature_answer
from viscoroll.case import example_text

CASE = tomllib.loads(example_text())


def response(server, method, path, body=None):
    """Return status, headers and content of the server's answer."""
    with closing(http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=60)) as connection:
        connection.request(method, path, body)
        response = connection.getresponse()
        return response.status, response.headers, response.read()


def test_the_page_is_served_with_its_case(server):
    status, headers, content = response(server, "GET", f"/{server.token}/")
    assert status == 200
    assert headers["Content-Type"] == "text/html; charset=utf-8"
    start = content.decode().split('id="start">')[1].split("</script>")[0]
    assert json.loads(start) == {"solver": "native", "case": CASE}


def test_all_files_that_the_page_refers_to_are_served(server):
    content = response(server, "GET", f"/{server.token}/")[2].decode()
    names = [part.split('"')[0] for part in content.split('href="')[1:] + content.split('src="')[1:]]
    files = [name for name in names if not name.startswith("data:")]
    assert sorted(files) == ["main.js", "page.css"]
    types = {"js": "text/javascript; charset=utf-8", "css": "text/css; charset=utf-8"}
    for name in files:
        status, headers, _ = response(server, "GET", f"/{server.token}/{name}")
        assert (status, headers["Content-Type"]) == (200, types[name.rpartition(".")[2]])


@pytest.mark.parametrize("path", ["/", "/solve", "/page.css", "/{wrong}/", "/{wrong}/solve", "/{token}"])
@pytest.mark.parametrize("method", ["GET", "POST"])
def test_requests_without_the_token_are_rejected(server, path, method):
    wrong = server.token[:-1] + ("A" if server.token[-1] != "A" else "B")
    status, _, content = response(server, method, path.format(wrong=wrong, token=server.token), "{}")
    assert (status, content) == (403, b"Forbidden")


@pytest.mark.parametrize(
    "name", ["server.py", "../server.py", "..%2Fserver.py", "package.json", "/etc/passwd", "../../../../../etc/passwd"]
)
def test_no_other_file_is_served(server, name):
    assert response(server, "GET", f"/{server.token}/{name}")[0] == 404


def test_the_server_listens_only_to_this_machine(server):
    assert server.server_address[0] == "127.0.0.1"


def test_answers_agree_with_the_package(server):
    request = {"case": CASE, "fields": True}
    status, headers, content = response(server, "POST", f"/{server.token}/solve", json.dumps(request))
    assert (status, headers["Content-Type"]) == (200, "application/json; charset=utf-8")
    assert json.loads(content) == answer(request)
    assert json.loads(response(server, "POST", f"/{server.token}/scalars")[2]) == scalars()


def test_case_files_and_temperatures_are_answered(server):
    content = response(server, "POST", f"/{server.token}/open", json.dumps(example_text()))[2]
    assert json.loads(content) == {"tables": CASE, "skipped": []}
    content = response(server, "POST", f"/{server.token}/temperature", json.dumps({"case": CASE, "thermal": {}}))[2]
    assert json.loads(content) == temperature_answer({"case": CASE, "thermal": {}})


def test_errors_are_answers(server):
    request = {"case": CASE | {"rolling": CASE["rolling"] | {"load": -1.0}}}
    status, _, content = response(server, "POST", f"/{server.token}/solve", json.dumps(request))
    assert status == 200
    assert json.loads(content)["error"]["parameter"] == "load"


@pytest.mark.parametrize(
    ("name", "body", "status"),
    [("solve", b"{", 400), ("solve", b"\xff", 400), ("solve", b"[" * 100_000, 400), ("other", b"{}", 404)],
)
def test_malformed_requests(server, name, body, status):
    assert response(server, "POST", f"/{server.token}/{name}", body)[0] == status


def test_requests_that_are_too_long(server):
    with closing(http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=60)) as connection:
        connection.putrequest("POST", f"/{server.token}/solve")
        connection.putheader("Content-Length", "1000001")
        connection.endheaders()
        assert connection.getresponse().status == 413


def test_two_windows_are_answered(server):
    slow = CASE | {"rolling": CASE["rolling"] | {"friction": 0.3}, "numerics": {"accuracy": 1e-3}}
    found = []
    ask = lambda case: found.append(response(server, "POST", f"/{server.token}/solve", json.dumps({"case": case})))  # noqa: E731
    windows = [threading.Thread(target=ask, args=(case,)) for case in (slow, CASE)]
    for window in windows:
        window.start()
    for window in windows:
        window.join()
    # The fast request does not wait for the slow one.
    assert [json.loads(content)["result"]["scalars"]["friction"] for *_, content in found] == [0.0, 0.3]


def test_a_solve_ends_if_its_window_is_closed(server):
    demanding = CASE | {"rolling": CASE["rolling"] | {"friction": 0.3}, "numerics": {"accuracy": 1e-4}}
    body = json.dumps({"case": demanding}).encode()
    host = f"127.0.0.1:{server.server_port}"
    head = f"POST /{server.token}/solve HTTP/1.0\r\nHost: {host}\r\nContent-Length: {len(body)}\r\n\r\n".encode()
    before = threading.active_count()
    with socket.create_connection(("127.0.0.1", server.server_port)) as window:
        window.sendall(head + body)
        time.sleep(0.3)
        assert threading.active_count() > before
    deadline = time.monotonic() + 10.0
    while threading.active_count() > before and time.monotonic() < deadline:
        time.sleep(0.02)
    assert threading.active_count() == before


@pytest.mark.skipif(os.name == "nt", reason="on Windows, SIGINT goes to all processes of a console")
def test_ctrl_c_ends_the_server_during_a_solve():
    words = [sys.executable, "-m", "viscoroll", "app", "--no-browser"]
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as program:
        address = program.stdout.readline().split()[0]
        port, token = address.removeprefix("http://127.0.0.1:").rstrip("/").split("/")
        demanding = CASE | {"rolling": CASE["rolling"] | {"friction": 0.3}, "numerics": {"accuracy": 1e-4}}
        with closing(http.client.HTTPConnection("127.0.0.1", int(port))) as window:
            window.request("POST", f"/{token}/solve", json.dumps({"case": demanding}))
            # This connection sends nothing, like those that browsers open in advance.
            with socket.create_connection(("127.0.0.1", int(port))):
                time.sleep(0.3)
                program.send_signal(signal.SIGINT)
                output, messages = program.communicate(timeout=10)
    assert (program.returncode, output, messages) == (0, "", "")


def test_the_command_reports_skipped_tables_and_errors(tmp_path, monkeypatch):
    begun = []
    monkeypatch.setattr("viscoroll.app.serve", lambda case, **_: begun.append(case))
    path = tmp_path / "case.toml"
    others = '\n[thermal]\nconvection = 10.0\nambient = "20 degC"\n[sweep]\n"rolling.load" = [1.0, 2.0]\n'
    path.write_text(example_text() + others, encoding="utf-8")
    done = command("app", path)
    assert "skipped in case.toml: the page does not support the table [sweep]" in done.stderr
    started = CASE | {"thermal": {"convection": 10.0, "ambient": 293.15}}
    assert begun == [started]
    path.write_text(example_text().replace("load = 100.0", "laod = 100.0"), encoding="utf-8")
    done = command("app", path)
    assert done.returncode == 2
    assert "did you mean load?" in done.stderr
    assert command("app", tmp_path / "none.toml").returncode == 2
    command("app", "--no-browser")
    assert begun == [started, None]
