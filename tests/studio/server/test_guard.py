"""Who is answered: those who know the token, from this computer, under this studio's name."""

import pytest

from tests.own_loop import awaited
from torquerig.studio.server.guard import REFUSED, Guard

TOKEN, PORT = "right-token", 8123
HOST = (b"host", b"127.0.0.1:8123")


async def application(scope, receive, send):
    if scope["type"] == "websocket":
        await send({"type": "websocket.accept"})
        return
    await send({"type": "http.response.start", "status": 200, "headers": []})
    await send({"type": "http.response.body", "body": b"the page"})


def answer(query="", headers=(HOST,), kind="http"):
    sent = []

    async def send(message):
        sent.append(message)

    scope = {"type": kind, "query_string": query.encode(), "headers": list(headers), "path": "/"}
    awaited(Guard(application, token=TOKEN, port=PORT)(scope, None, send))
    return sent


def status(**how):
    return answer(**how)[0].get("status")


def cookie(value, port=PORT):
    return (b"cookie", f"other=1; torquerig_studio_{port}={value}".encode())


def test_the_token_in_the_address_opens_the_page_and_sets_a_cookie_for_this_studio_alone():
    first = answer(query=f"step=rig&token={TOKEN}")[0]
    assert first["status"] == 200
    said = dict(first["headers"])[b"set-cookie"].decode()
    assert said.startswith(f"torquerig_studio_{PORT}={TOKEN};")
    assert "HttpOnly" in said
    assert "SameSite=Strict" in said


def test_the_cookie_opens_it_again_without_the_token_in_the_address():
    assert status(headers=(HOST, cookie(TOKEN))) == 200


@pytest.mark.parametrize(
    "how",
    [
        {}, {"query": "token="}, {"query": "token=wrong"}, {"query": f"token={TOKEN}x"}, {"query": "token=%FF%FE"},
        {"headers": (HOST, cookie("wrong"))}, {"headers": (HOST, cookie(TOKEN, port=8124))},
        {"headers": (HOST, (b"cookie", b"=;\xff\x00=="))},
        {"query": f"token={TOKEN}", "headers": ((b"host", b"evil.example:8123"),)},
        {"query": f"token={TOKEN}", "headers": (HOST, (b"origin", b"http://evil.example"))},
        {"query": f"token={TOKEN}", "headers": ()},
    ],
)  # fmt: skip
def test_every_other_request_is_refused(how):
    sent = answer(**how)
    assert sent[0]["status"] == 403
    assert sent[1]["body"].decode() == REFUSED


def test_a_websocket_without_the_token_is_closed_before_it_is_accepted():
    assert answer(kind="websocket")[0]["type"] == "websocket.close"
    assert answer(kind="websocket", headers=(HOST, cookie(TOKEN)))[0]["type"] == "websocket.accept"


def test_the_page_may_load_from_itself_only():
    policy = dict(answer(query=f"token={TOKEN}")[0]["headers"])[b"content-security-policy"].decode()
    assert "default-src 'self'" in policy
    assert "http" not in policy
    assert "*" not in policy
