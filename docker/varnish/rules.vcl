# What Varnish keeps of talusd's answers, and for how long: talus.vcl and cluster.vcl, which say where talusd is, include it.

sub vcl_recv {
    # Varnish itself would pipe methods that it does not know, and looks no more at what follows.
    if (req.method != "GET" && req.method != "HEAD" && req.method != "OPTIONS") {
        return (synth(405));
    }
    # talusd knows no cookies, and what others have set for this host would keep answers out of the cache.
    unset req.http.Cookie;
    # talusd looks at no query of the viewer's files: anybody can make up as many as would fill the cache.
    if (req.url !~ "^/v1/") {
        set req.url = regsub(req.url, "\?.*$", "");
    }
    # Which land was edited is told as it is now, and so are the viewer's pages; while talusd is away, as it was (vcl_deliver
    # comes back here).
    if (req.url ~ "^/v1/[^/]+/[^/]+/edits/" || req.url !~ "^/v1/") {
        set req.grace = 0s;
        if (req.restarts > 0) {
            set req.grace = 7d;
        }
    }
    # Varnish has added the client to X-Forwarded-For. What is piped is not looked at any more.
    if (req.url == "/v1/stream" && req.http.Upgrade ~ "(?i)^websocket$") {
        return (pipe);
    }
}

# Without the Host, which anybody can make up too: all that is kept is the same for each. A Varnish with other sites beside
# talusd adds it here.
sub vcl_hash {
    hash_data(req.url);
    return (lookup);
}

sub vcl_pipe {
    set bereq.http.Upgrade = req.http.Upgrade;
    set bereq.http.Connection = "Upgrade";
}

sub vcl_backend_response {
    if (beresp.status >= 500 && bereq.is_bgfetch) {
        return (abandon);  # what is held is better
    }
    if (bereq.http.Origin && beresp.http.Cache-Control ~ "no-store") {
        # Of an origin that is not listed. That it is not kept is known for a second, not for two minutes for each that is
        # made up.
        set beresp.uncacheable = true;
        set beresp.ttl = 1s;
        set beresp.grace = 0s;
        return (deliver);
    }
    if (beresp.status == 200 && bereq.url == "/v1/world" && !bereq.http.Authorization) {
        # What a client asks for first: one answer does for a second, and for as long as talusd is away.
        set beresp.ttl = 1s;
        set beresp.grace = 7d;
        return (deliver);
    }
    if (beresp.status == 200 && bereq.url ~ "^/v1/[^/]+/[^/]+/edits/" && !bereq.http.Authorization &&
        beresp.http.Cache-Control == "no-cache") {
        # Which columns were edited: all who look there within a second get one answer, which is then asked for again.
        set beresp.ttl = 1s;
        set beresp.grace = 7d;
        return (deliver);
    }
    if (beresp.status == 200 && bereq.url !~ "^/v1/" && beresp.http.Cache-Control == "no-cache") {
        # The viewer's pages likewise. Its assets, whose names change with their bytes, are kept as chunks are.
        set beresp.ttl = 1s;
        set beresp.grace = 7d;
        return (deliver);
    }
    # Chunks, which never change under their path; but for land that is edited just now, which nobody keeps.
    if (beresp.status == 200 && beresp.ttl > 0s && beresp.http.Cache-Control !~ "no-store") {
        set beresp.grace = 30d;
    }
}

sub vcl_deliver {
    if (resp.status >= 500 && req.restarts == 0 && (req.url ~ "^/v1/[^/]+/[^/]+/edits/" || req.url !~ "^/v1/")) {
        return (restart);
    }
    if (obj.hits > 0) {
        set resp.http.X-Cache = "HIT";
    } else {
        set resp.http.X-Cache = "MISS";
    }
}
