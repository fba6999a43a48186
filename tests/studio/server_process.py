# SPDX-License-Identifier: MIT
"""The studio as a process with a socket, for its test."""
import http.client
import json
import re
import signal
import subprocess

TIMEOUT = 120


class Server:
    def __init__(self, program, target):
        self.program = program
        self.process = subprocess.Popen([program, "studio", str(target), "--no-open"], stdout=subprocess.PIPE, text=True)
        line = self.process.stdout.readline()
        found = re.search(r"http://127\.0\.0\.1:(\d+)/#([0-9a-f]{32})", line)
        assert found, f"no address in {line!r}"
        self.port, self.token = int(found[1]), found[2]

    def ask(self, method, path, body=None, headers=None, token=True):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=TIMEOUT)
        given = {"X-Talus-Token": self.token} if token else {}
        if isinstance(body, (dict, list)):
            body = json.dumps(body)
        connection.request(method, path, body.encode() if isinstance(body, str) else body, {**given, **(headers or {})})
        answer = connection.getresponse()
        data = answer.read()
        connection.close()
        self.headers = dict(answer.getheaders())
        try:
            return answer.status, json.loads(data)
        except ValueError:
            return answer.status, data

    def watch(self, run, stop_at=None):
        """Events of a run up to its end, or up to the first for which stop_at() holds."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=TIMEOUT)
        connection.request("GET", f"/api/runs/{run}/events?token={self.token}")
        answer = connection.getresponse()
        assert answer.status == 200 and answer.getheader("Content-Type") == "text/event-stream", answer.status
        events, kind = [], None
        for line in iter(answer.readline, b""):
            line = line.decode().rstrip("\n")
            if line.startswith("event: "):
                kind = line[7:]
            elif line.startswith("data: "):
                events.append((kind, json.loads(line[6:])))
                if kind == "done" or (stop_at and stop_at(events[-1])):
                    break
        connection.close()
        return events

    def end(self, with_signal=signal.SIGINT):
        self.process.send_signal(with_signal)
        return self.process.wait(TIMEOUT)
