"""`plsc live` as a whole, by its sockets: what it serves, whom it refuses, and
that no client takes it down. usage: live_test.py PLSC"""

import http.client
import json
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.parse

PLSC = sys.argv.pop(1)
ROBOT = """plsc 1
genotype walker
alphabet plasticoding 1
iterations 1
rule C -> { C add_front A1(0.5, 2.0, 2.0, 1.0) move_front add_front B }
"""


class Live:
    """A server of its own, that ends with the block."""

    def __init__(self, *words):
        self.process = subprocess.Popen(
            [PLSC, "live", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.address = self.process.stdout.readline().decode().strip()
        parts = urllib.parse.urlsplit(self.address)
        self.port, self.root = parts.port, parts.path

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.communicate()

    def get(self, target, method="GET", body=None, root=None, **headers):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        headers.setdefault("Host", f"127.0.0.1:{self.port}")
        connection.request(method, (self.root if root is None else root) + target,
                           body, headers)
        response = connection.getresponse()
        text = response.read()
        connection.close()
        return response.status, text

    def ask(self, **question):
        status, text = self.get("ask", "POST", json.dumps(question))
        return status, json.loads(text)

    def alive(self):
        return self.process.poll() is None and self.get("")[0] == 200

    def raw(self, data=b""):
        client = socket.create_connection(("127.0.0.1", self.port))
        client.sendall(data)
        return client


class Events:
    """What the server pushes."""

    def __init__(self, live):
        self.client = live.raw(f"GET {live.root}events HTTP/1.1\r\nHost: "
                               f"127.0.0.1:{live.port}\r\n\r\n".encode())
        self.client.settimeout(60)
        self.text = b""

    def wait(self, wanted):
        while wanted not in self.text:
            more = self.client.recv(1 << 16)
            if not more:
                raise AssertionError("the stream ended")
            self.text += more


class LiveTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name) / "a.pls"
        self.path.write_text(ROBOT)

    def tearDown(self):
        self.folder.cleanup()

    def test_serves_and_answers(self):
        with Live(str(self.path)) as live:
            status, page = live.get("")
            self.assertEqual(status, 200)
            self.assertIn(b"<title>a.pls</title>", page)
            status, answer = live.ask(id=7, ask="check", text=ROBOT)
            self.assertEqual((status, answer["id"]), (200, 7))
            status, answer = live.ask(id=8, ask="live", text=ROBOT, record=True)
            self.assertEqual((status, answer["id"]), (200, 8))
            for nonsense in ("", "{", "[]", "null", '{"ask": "x"}', '{"ask": 1}',
                             '{"ask": "live", "text": 5}', "\xff" * 100,
                             "[" * 100000):
                status, text = live.get("ask", "POST", nonsense.encode("latin1"))
                self.assertEqual(status, 200, nonsense[:20])
                self.assertFalse(json.loads(text)["ok"])
            self.assertTrue(live.alive())

    def test_refuses(self):
        with Live(str(self.path)) as live:
            own = f"127.0.0.1:{live.port}"
            self.assertEqual(live.get("", root="/")[0], 403)
            self.assertEqual(live.get("", root="/" + "0" * 32 + "/")[0], 403)
            self.assertEqual(live.get("", Host="evil.example")[0], 403)
            self.assertEqual(live.get("", Host=f"evil.example:{live.port}")[0], 403)
            self.assertEqual(live.get("", Origin="http://evil.example")[0], 403)
            self.assertEqual(live.get("", Origin="null")[0], 403)
            self.assertEqual(live.get("", Origin=f"http://{own}")[0], 200)
            for target in ("a.pls", "../a.pls", "..%2fa.pls", "/etc/passwd",
                           "%2e%2e/", "robot", "run", "study"):
                self.assertEqual(live.get(target)[0], 404, target)
            self.assertEqual(live.get("ask")[0], 405)
            self.assertEqual(live.get("", "POST", "x")[0], 405)
            self.assertEqual(live.get("save", "DELETE")[0], 405)
            self.assertEqual(self.path.read_text(), ROBOT)
            for line in subprocess.run(
                    ["ss", "-Hltn"], capture_output=True, text=True,
                    check=False).stdout.splitlines() if os.path.exists(
                        "/usr/bin/ss") else ():
                if f":{live.port} " in line:
                    self.assertIn("127.0.0.1:", line)

    def test_file_changes_are_pushed(self):
        with Live(str(self.path)) as live:
            events = Events(live)
            events.wait(b"walker")
            for turn in range(3):
                text = ROBOT.replace("walker", f"turn{turn}")
                other = self.path.with_suffix(".new")
                other.write_text(text)
                os.rename(other, self.path)
                events.wait(f"turn{turn}".encode())
            os.remove(self.path)
            events.wait(b"No such file")
            self.path.write_text(ROBOT.replace("walker", "again"))
            events.wait(b"genotype again")

    def test_many_saves_do_not_queue_up(self):
        with Live(str(self.path)) as live:
            events = Events(live)
            events.wait(b"walker")
            for turn in range(400):
                self.path.write_text(ROBOT.replace("walker", f"turn{turn}_"))
            events.wait(b"turn399_")
            # Some of the 400 were seen, far from all; the last one was.
            self.assertLess(events.text.count(b"event: file"), 200)

    def test_saves_and_conflicts(self):
        with Live(str(self.path)) as live:
            events = Events(live)
            events.wait(b'"version":"')
            version = events.text.split(b'"version":"')[1].split(b'"')[0].decode()

            def save(text, of):
                status, answer = live.get("save", "POST", json.dumps(
                    {"text": text, "version": of}))
                return status, json.loads(answer)

            status, answer = save("// mine\n", version)
            self.assertEqual(status, 200)
            self.assertEqual(self.path.read_text(), "// mine\n")
            self.path.write_text("// theirs\n")
            status, answer = save("// mine too\n", answer["version"])
            self.assertEqual((status, answer["ok"]), (200, False))
            self.assertEqual(answer["conflict"]["text"], "// theirs\n")
            self.assertEqual(self.path.read_text(), "// theirs\n")
            self.assertEqual(os.listdir(self.folder.name), ["a.pls"])

    def test_hostile_clients(self):
        with Live(str(self.path)) as live:
            events = Events(live)
            events.wait(b"walker")
            held = []
            for turn in range(2000):  # silent, half, broken, huge
                try:
                    held.append(live.raw(
                        (b"", b"GET /", b"\x16\x03\x01" * 20, b"A: " + b"a" * 40000,
                         f"POST {live.root}ask HTTP/1.1\r\nHost: 127.0.0.1:"
                         f"{live.port}\r\nContent-Length: 99999999999\r\n\r\n"
                         .encode())[turn % 5]))
                except OSError:
                    pass  # shown out already
                if len(held) > 500:
                    held.pop(0).close()
            self.assertTrue(live.alive())
            for client in held:
                client.close()
            self.path.write_text(ROBOT.replace("walker", "still"))
            events.wait(b"genotype still")  # who listens was not shown out

    def test_hostile_robots(self):
        endless = ("seasons:\n  - {name: flat, terrain: flat, duration: "
                   "1000000000 s}\n")
        grows = ROBOT.replace("iterations 1", "iterations 9") + (
            "rule B -> { " + "B " * 60 + "}\n")
        with Live(str(self.path)) as live:
            for question in ({"ask": "live", "text": ROBOT, "scenario": endless},
                             {"ask": "develop", "text": grows},
                             {"ask": "explain", "text": grows},
                             {"ask": "live", "text": grows},
                             {"ask": "check", "text": "(" * 1000000},
                             {"ask": "format", "text": "\0" * 1000}):
                status, answer = live.ask(**question)
                self.assertFalse(answer["ok"] and question["ask"] != "check",
                                 question["ask"])
            self.assertTrue(live.alive())

    def test_ends_at_once(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with Live(str(self.path)) as live:
                Events(live).wait(b"walker")
                live.process.send_signal(number)
                self.assertEqual(live.process.wait(timeout=20), 0)

    def test_ends_when_nobody_looks(self):
        with Live(str(self.path), "--idle", "0.2") as live:
            events = Events(live)
            events.wait(b"walker")
            time.sleep(0.5)
            self.assertIsNone(live.process.poll())
            events.client.close()
            self.assertEqual(live.process.wait(timeout=20), 0)

    def test_bad_starts(self):
        def refused(*words):
            ended = subprocess.run([PLSC, "live", *words], capture_output=True,
                                   text=True, timeout=60, check=False)
            self.assertNotEqual(ended.returncode, 0, words)
            self.assertEqual(ended.stdout, "")
            return ended.stderr

        self.assertIn("none.pls", refused(self.folder.name + "/none.pls"))
        self.assertIn("study", refused(self.folder.name))
        self.assertIn("'example.org' is no address",
                      refused(str(self.path), "--host", "example.org"))
        self.assertIn("none.yaml", refused(str(self.path), "--scenario",
                                           self.folder.name + "/none.yaml"))
        with Live(str(self.path)) as live:
            self.assertIn("already in use",
                          refused(str(self.path), "--port", str(live.port)))


if __name__ == "__main__":
    unittest.main()
