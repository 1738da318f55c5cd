const __vite__mapDeps=(i,m=__vite__mapDeps,d=(m.f||(m.f=["./overlay-dZZ7W0tc.js","./screen-BRwkW3ca.js","./token_dialog-CbDq5MIR.js","./token_dialog-DTB_VvDe.css"])))=>i.map(i=>d[i]);
import{w as Vd,m as wi,f as Mt,s as fe,a as ec,b as Wd,T as Xd,S as qd,r as dl,c as $d,d as Yd,e as Kd,g as Zd}from"./token_dialog-CbDq5MIR.js";const Jd=(function(){const t=typeof document<"u"&&document.createElement("link").relList;return t&&t.supports&&t.supports("modulepreload")?"modulepreload":"preload"})(),Qd=function(i,t){return new URL(i,t).href},nc={},jd=function(t,e,n){let s=Promise.resolve();if(e&&e.length>0){let a=function(h){return Promise.all(h.map(u=>Promise.resolve(u).then(d=>({status:"fulfilled",value:d}),d=>({status:"rejected",reason:d}))))};const o=document.getElementsByTagName("link"),l=document.querySelector("meta[property=csp-nonce]"),c=l?.nonce||l?.getAttribute("nonce");s=a(e.map(h=>{if(h=Qd(h,n),h in nc)return;nc[h]=!0;const u=h.endsWith(".css"),d=u?'[rel="stylesheet"]':"";if(!!n)for(let S=o.length-1;S>=0;S--){const p=o[S];if(p.href===h&&(!u||p.rel==="stylesheet"))return}else if(document.querySelector(`link[href="${h}"]${d}`))return;const _=document.createElement("link");if(_.rel=u?"stylesheet":Jd,u||(_.as="script"),_.crossOrigin="",_.href=h,c&&_.setAttribute("nonce",c),document.head.appendChild(_),u)return new Promise((S,p)=>{_.addEventListener("load",S),_.addEventListener("error",()=>p(new Error(`Unable to preload CSS for ${h}`)))})}))}function r(a){const o=new Event("vite:preloadError",{cancelable:!0});if(o.payload=a,window.dispatchEvent(o),!o.defaultPrevented)throw a}return s.then(a=>{for(const o of a||[])o.status==="rejected"&&r(o.reason);return t().catch(r)})};class Wt extends Error{constructor(t,e,n=0){super(e),this.kind=t,this.retryAfterMs=n}name="TalusError"}class tf{handlers=new Map;on(t,e){this.handlers.set(t,[...this.handlers.get(t)??[],e])}off(t,e){this.handlers.set(t,(this.handlers.get(t)??[]).filter(n=>n!==e))}emit(t,...e){for(const n of this.handlers.get(t)??[])n(...e)}}const ef=6,xs={first:0,last:-1};function qi(i){return Math.max(0,i.last-i.first+1)}function Ss(i,t){return i.first<=t&&t<=i.last}function bi(i,t){return{first:Math.max(i.first,t.first),last:Math.min(i.last,t.last)}}function la(i,t,e){return{first:Math.floor((i-t)/e),last:Math.floor((i+t)/e)}}function ic(i,t,e){return{first:Math.ceil(i.first*t/e)+0,last:Math.floor((i.last+1)*t/e)-1}}function nf(i,t){const n=s=>Math.max(-68719476736,Math.min(68719476736,s));return{first:Math.floor((Math.floor(n(i.minY)/t)-1)/32),last:Math.floor(Math.floor((n(i.maxY)-1)/t)/32)}}function sf(i){const t=2**(31-i.lod),e={first:-t,last:t-1};return{lod:i.lod,x:bi(i.x,e),y:bi(i.y,e),z:bi(i.z,e),innerX:bi(i.innerX,e),innerZ:bi(i.innerZ,e)}}function sc(i){const t=qi(bi(i.x,i.innerX))*qi(bi(i.z,i.innerZ));return(qi(i.x)*qi(i.z)-t)*qi(i.y)}function rf(i,t){const e=Math.floor(i.centre.x/32),n=Math.floor(i.centre.y/32),s=Math.floor(i.centre.z/32),r=(o,l)=>({lod:o,x:la(e,l,2**o),y:la(n,i.verticalRadius,2**o),z:la(s,l,2**o),innerX:xs,innerZ:xs}),a=[r(0,i.horizontalRadius)];for(const o of i.rings??[]){const l=a[a.length-1],c=r(o.lod,o.radius),h=!i.horizon||a.length>1;a.push({...c,y:i.horizon?nf(t,2**o.lod):c.y,innerX:h?ic(l.x,2**l.lod,2**o.lod):xs,innerZ:h?ic(l.z,2**l.lod,2**o.lod):xs})}return a}class no{boxes;count;uncutCount;byLod=[];constructor(t,e={minY:0,maxY:0}){const n=rf(t,e);this.boxes=n.map(sf),this.count=this.boxes.reduce((s,r)=>s+sc(r),0),this.uncutCount=n.reduce((s,r)=>s+sc(r),0);for(const s of this.boxes)this.byLod[s.lod]=s}hasColumn(t,e,n){const s=this.byLod[t];return s!==void 0&&ca(s,e,n)}covers(t){const e=this.byLod[t.lod];return e!==void 0&&Ss(e.y,t.y)&&ca(e,t.x,t.z)}rows(t,e,n){return this.hasColumn(t,e,n)?this.byLod[t].y:xs}forEachColumn(t){for(const e of this.boxes)if(qi(e.y)!==0)for(let n=e.z.first;n<=e.z.last;++n)for(let s=e.x.first;s<=e.x.last;++s)ca(e,s,n)&&t(e.lod,s,n,e.y)}forEach(t){this.forEachColumn((e,n,s,r)=>{for(let a=r.first;a<=r.last;++a)t({lod:e,x:n,y:a,z:s})})}}function ca(i,t,e){return Ss(i.x,t)&&Ss(i.z,e)&&!(Ss(i.innerX,t)&&Ss(i.innerZ,e))}function Es(i){throw new Wt("out_of_range",i)}function af(i){for(const r of["x","y","z"])Number.isFinite(i.centre[r])||Es(`the View's centre has ${r} = ${i.centre[r]}; it must be a finite number`);const t=(r,a)=>{(!Number.isInteger(r)||r<0||r>65535)&&Es(`the View's ${a} is ${r}; it must be a whole number from 0 to 65535`)};t(i.horizontalRadius,"horizontalRadius"),t(i.verticalRadius,"verticalRadius");let e=0,n=i.horizontalRadius;for(const r of i.rings??[])t(r.radius,`radius of level ${r.lod}`),(!Number.isInteger(r.lod)||r.lod<=e||r.lod>ef||r.radius<=n)&&Es(`the View's ring of level ${r.lod} and radius ${r.radius} does not grow from level ${e}, ${n}`),e=r.lod,n=r.radius;const s=r=>Math.max(-4503599627370496,Math.min(2**52,Math.floor(r)));return{centre:{x:s(i.centre.x),y:s(i.centre.y),z:s(i.centre.z)},...i.direction===void 0?{}:{direction:{...i.direction}},horizontalRadius:i.horizontalRadius,verticalRadius:i.verticalRadius,rings:(i.rings??[]).map(r=>({lod:r.lod,radius:r.radius})),horizon:i.horizon===!0}}function rc(i,t,e){const n=(s,r,a)=>{s>r&&Es(`the View's ${a} is ${s}; this server allows ${r}`)};n(i.horizontalRadius,e.viewHorizontalRadius,"horizontalRadius"),n(i.verticalRadius,e.viewVerticalRadius,"verticalRadius");for(const s of i.rings??[])n(s.radius,e.viewHorizontalRadius*2**s.lod,`radius of level ${s.lod}`);n(t.uncutCount,e.viewChunks,"number of chunks"),i.horizon&&!e.viewHorizon&&Es("the View has a horizon, which this server does not know")}const of=6e4;class lf{constructor(t={}){this.policy=t}failures=0;next(t=0){const{maxAttempts:e=1/0,firstDelayMs:n=500,maxDelayMs:s=1e4}=this.policy;if(++this.failures>e)return null;const r=Math.min(s,n*2**Math.min(this.failures-1,30));return Math.round(Math.min(t,of)+Math.random()*r)}reset(){this.failures=0}}function Tn(i){return`${i.lod}/${i.x}/${i.y}/${i.z}`}function cf(i,t){return i.x===t.x&&i.y===t.y&&i.z===t.z&&i.lod===t.lod}function mu(i){const t=2**(31-i.lod),e=s=>Number.isInteger(s)&&-t<=s&&s<t;if(!(Number.isInteger(i.lod)&&i.lod>=0&&i.lod<=6&&e(i.x)&&e(i.y)&&e(i.z)))throw new Wt("out_of_range",`chunk ${Tn(i)} (level/x/y/z) lies in no world: levels are 0 to 6, coordinates whole and within 2^31 >> level`)}class hf{view=null;shape=null;delivered=new Map;replace(t,e){this.view=t,this.shape=t===null?null:new no(t,e);const n=[];for(const[s,{key:r}]of this.delivered)this.shape?.covers(r)||(this.delivered.delete(s),n.push(r));return n}forget(){const t=[...this.delivered.values()].map(({key:e})=>e);return this.delivered.clear(),t}forgetRevisions(){for(const[t,e]of this.delivered)this.delivered.set(t,{...e,revision:-1n})}deliver(t){if(!this.shape?.covers(t.key))return!1;const e=Tn(t.key),n=this.delivered.get(e),{key:s,revision:r,hash:a,material:o}=t;if(n!==void 0){if(n.revision>r)return!1;const l=a!==null&&n.hash!==null?a===n.hash:uf(o,n.material);if(this.delivered.set(e,{key:s,revision:r,hash:a??n.hash,material:o}),l)return!1}else this.delivered.set(e,{key:s,revision:r,hash:a,material:o});return!0}has(t){return this.delivered.has(Tn(t))}hashOf(t){return this.delivered.get(Tn(t))?.hash??null}isWhole(){return this.delivered.size===(this.shape?.count??0)}missing(){const t=[];return this.isWhole()||this.shape?.forEach(e=>{this.has(e)||t.push(e)}),t}}function uf(i,t){return i!==null&&i===t}const df=50,ff={chunks:0,uniformChunks:0,unchangedChunks:0,receivedBytes:0,sentBytes:0,chunkBytes:0,connections:0,requests:0,latencyMs:null,firstChunkMs:null,viewCompleteMs:null};class gu{constructor(t){this.options=t,this.backoff=new lf(t.reconnect),globalThis.addEventListener?.("online",this.retryNow)}world=null;connected=!1;stats={...ff};tracker=new hf;backoff;isClosed=!1;events=new tf;closeError=null;wanted=null;viewTimer;retryTimer;appliedAt=-1/0;viewSince=0;on(t,e){return this.events.on(t,e),this}off(t,e){return this.events.off(t,e),this}emit(t,...e){this.events.emit(t,...e)}ready(){return new Promise((t,e)=>{if(this.connected&&this.world!==null){t(this.world);return}if(this.isClosed){e(this.closedError());return}const n=()=>{this.off("connected",s).off("closed",r)},s=a=>{n(),t(a)},r=()=>{n(),e(this.closedError())};this.on("connected",s).on("closed",r)})}closedError(){return this.closeError??new Wt("closed","the client is closed")}setView(t){if(this.isClosed)throw this.closedError();const e=t===null?null:af(t);e!==null&&this.world!==null&&rc(e,new no(e,this.world),this.world.limits),!mf(e,this.wanted)&&(this.wanted=e,this.applyViewSoon())}applyViewSoon(){if(!this.connected||this.viewTimer!==void 0)return;const t=this.appliedAt+df-performance.now();if(t<=0){this.applyView();return}this.viewTimer=setTimeout(()=>{this.viewTimer=void 0,this.connected&&this.applyView()},t)}applyView(){const t=this.wanted,e=this.tracker.view;this.appliedAt=performance.now(),(e===null||t===null||!_u(e,t))&&(this.viewSince=this.appliedAt,this.stats.firstChunkMs=this.stats.viewCompleteMs=null);for(const n of this.tracker.replace(t,this.world))this.emit("chunkLeft",n);this.connected&&this.tracker.view===t&&this.viewApplied()}joined(t){const e=this.world,n=e!==null&&e.fingerprint===t.fingerprint;if(n)e.storeId!==t.storeId&&this.tracker.forgetRevisions();else for(const s of this.tracker.forget())this.emit("chunkLeft",s);if(this.world=t,this.connected=!0,++this.stats.connections,this.worldKnown(n),this.emit("connected",t,e===null||n),!!this.connected){if(this.wanted!==null)try{rc(this.wanted,new no(this.wanted,t),t.limits)}catch(s){this.wanted=this.tracker.view=null,this.emit("error",s)}this.wanted!==null&&this.applyView()}}deliver(t){return this.tracker.deliver(t)?(++this.stats.chunks,t.material!==null&&++this.stats.uniformChunks,this.stats.firstChunkMs??=performance.now()-this.viewSince,this.emit("chunk",t),!0):!1}tellComplete(){this.tracker.view===this.wanted&&(this.stats.viewCompleteMs??=performance.now()-this.viewSince,this.emit("viewComplete",this.tracker.view))}lost(t){if(this.isClosed)return;this.connected=!1,clearTimeout(this.viewTimer),this.viewTimer=void 0;const e=t.kind==="refused"?null:this.backoff.next(t.retryAfterMs);if(this.emit("disconnected",t,e),!this.isClosed){if(e===null){this.end(t);return}this.retryTimer=setTimeout(this.retryNow,e)}}retryNow=()=>{this.retryTimer!==void 0&&(clearTimeout(this.retryTimer),this.retryTimer=void 0,this.attempt())};end(t){this.isClosed||(this.isClosed=!0,this.connected=!1,this.closeError=t,clearTimeout(this.viewTimer),clearTimeout(this.retryTimer),this.retryTimer=void 0,globalThis.removeEventListener?.("online",this.retryNow),this.stopped(),this.emit("closed",t))}close(){this.end(null)}}function pf(i,t){return JSON.stringify(i.rings)===JSON.stringify(t.rings)}function _u(i,t){const e=n=>Math.floor(n/32);return e(i.centre.x)===e(t.centre.x)&&e(i.centre.y)===e(t.centre.y)&&e(i.centre.z)===e(t.centre.z)&&i.horizontalRadius===t.horizontalRadius&&i.verticalRadius===t.verticalRadius&&i.horizon===t.horizon&&pf(i,t)}function mf(i,t){return i===null||t===null?i===t:_u(i,t)&&gf(i.direction,t.direction)}function gf(i,t){if(i===void 0||t===void 0)return i===t;const e=Math.hypot(i.x,i.y,i.z)*Math.hypot(t.x,t.y,t.z);return!(e>0)||i.x*t.x+i.y*t.y+i.z*t.z>.97*e}function vu(i){const t=[3,0,1];let e=i;for(;e>=128;e>>=7)t.push(e&127|128);return t.push(e),Uint8Array.from(t)}function Tr(i){if(i.length<4||i.length>6||i[0]!==3||i[1]!==0||i[2]!==1)return null;let t=0;for(let n=3;n<i.length;++n)t|=(i[n]&127)<<7*(n-3);const e=vu(t&65535);return e.length===i.length&&e.every((n,s)=>n===i[s])?t:null}const ac=1<<20,io=65536;function Bt(i){return new Wt("broken_protocol",`the server sent ${i}`)}let _f=class{constructor(t){this.bytes=t,this.view=new DataView(t.buffer,t.byteOffset,t.byteLength)}view;textBytes=0;tables=0;root(){return this.check(4,4),this.table(4+this.view.getUint32(4,!0))}check(t,e){if(t<4||t+e>this.bytes.length)throw Bt("a frame with an offset past its end")}table(t){if(++this.tables>io)throw Bt(`a frame with more than ${io} tables`);return new Sf(this,t)}text(t,e){if(this.textBytes+=e,this.textBytes>ac)throw Bt(`a frame with more than ${ac} bytes of text`);return vf.decode(this.bytes.subarray(t,t+e))}};const vf=new TextDecoder,xf={at:0,count:0};class Sf{constructor(t,e){if(this.frame=t,this.at=e,this.view=t.view,t.check(e,4),this.vtable=e-this.view.getInt32(e,!0),t.check(this.vtable,4),this.vtableBytes=this.view.getUint16(this.vtable,!0),this.bytes=this.view.getUint16(this.vtable+2,!0),this.vtableBytes<4||this.vtableBytes%2!==0)throw Bt("a table with a wrong list of fields");t.check(this.vtable,this.vtableBytes),t.check(e,this.bytes)}view;vtable;vtableBytes;bytes;struct(t,e){const n=4+2*t;if(n+2>this.vtableBytes)return 0;const s=this.view.getUint16(this.vtable+n,!0);if(s===0)return 0;if(s<4||s+e>this.bytes)throw Bt("a table with a field outside it");return this.at+s}u8(t){const e=this.struct(t,1);return e===0?0:this.view.getUint8(e)}bool(t){return this.u8(t)!==0}u16(t){const e=this.struct(t,2);return e===0?0:this.view.getUint16(e,!0)}i32(t){const e=this.struct(t,4);return e===0?0:this.view.getInt32(e,!0)}u32(t){return this.i32(t)>>>0}u64(t){const e=this.struct(t,8);return e===0?0n:this.view.getBigUint64(e,!0)}i64(t){return BigInt.asIntN(64,this.u64(t))}target(t){const e=this.struct(t,4);if(e===0)return 0;const n=e+this.view.getUint32(e,!0);return this.frame.check(n,4),n}table(t){const e=this.target(t);return e===0?null:this.frame.table(e)}vector(t,e){const n=this.target(t);if(n===0)return xf;const s=this.view.getUint32(n,!0);return this.frame.check(n+4,s*e),{at:n+4,count:s}}bytesOf(t){const{at:e,count:n}=this.vector(t,1);return new Uint8Array(this.frame.bytes.subarray(e,e+n))}text(t){const{at:e,count:n}=this.vector(t,1);return this.frame.text(e,n)}texts(t){return this.eachOffset(t,e=>{const n=this.view.getUint32(e,!0);return this.frame.check(e+4,n),this.frame.text(e+4,n)})}tables(t,e){return this.eachOffset(t,n=>e(this.frame.table(n)))}eachOffset(t,e){const{at:n,count:s}=this.vector(t,4);if(s>io)throw Bt(`a list of ${s} entries`);const r=[];for(let a=0;a<s;++a){const o=n+4*a+this.view.getUint32(n+4*a,!0);this.frame.check(o,4),r.push(e(o))}return r}get data(){return this.view}}const oc=4<<20;function Mf(i,t){const e=new DataView(i.buffer,i.byteOffset,i.byteLength);if(i.length<4||i[0]!==1||i[1]!==0)throw Bt("no column of chunks of version 1");const n=e.getUint16(2,!0),s=2**(31-t),r=[];let a=4,o=-s;for(let l=0;l<n;++l){if(a+12>i.length)throw Bt("a column of chunks that ends within a run");const c=e.getInt32(a,!0),h=e.getUint32(a+4,!0),u=e.getUint32(a+8,!0);if(a+=12,a+u>i.length)throw Bt("a column of chunks that ends within a payload");if(c!==o||h===0)throw Bt(`a column of chunks with row ${c} after row ${o-1}`);r.push({firstY:c,count:h,payload:i.subarray(a,a+u)}),a+=u,o+=h}if(a!==i.length||o!==s)throw Bt("a column of chunks that does not end as it should");return r}function yf(i,t){const e=new DataView(i.buffer,i.byteOffset,i.byteLength);if(i.length<4||i[0]!==1||i[1]!==t||e.getUint16(2,!0)!==0)throw Bt(`no square of ${t} x ${t} columns of version 1`);const n=[];let s=4;for(let r=0;r<t*t;++r){if(s+4>i.length)throw Bt("a square of columns that ends within one");const a=e.getUint32(s,!0);if(s+=4,s+a>i.length)throw Bt("a square of columns that ends within one");n.push(i.subarray(s,s+a)),s+=a}if(s!==i.length)throw Bt("a square of columns that goes on after its end");return n}class so extends Wt{constructor(t,e,n,s,r){super(t,e,n),this.status=s,this.code=r}}const lc=3e4,wf=16384;async function Ef({fetch:i,token:t},e,n,s,r="GET"){const a=AbortSignal.timeout(lc),o=new AbortController,l=()=>o.abort();s.addEventListener("abort",l),a.addEventListener("abort",l);try{const c=await i(e,{method:r,signal:o.signal,...t===void 0?{}:{headers:{Authorization:`Bearer ${t}`}}});if(!c.ok)throw await bf(c,e);return await xu(c,n,e)}catch(c){if(c instanceof Wt)throw c;if(s.aborted)throw new Wt("cancelled",`the request for ${e} was given up`);if(a.aborted)throw new Wt("timed_out",`${e} did not answer within ${lc/1e3} s`);const h=c.cause?.message??c.message;throw new Wt("unreachable",`${e} cannot be reached: ${h}`)}finally{s.removeEventListener("abort",l),a.removeEventListener("abort",l),o.abort()}}async function xu(i,t,e){const n=i.body?.getReader();if(n===void 0)return new Uint8Array(0);let s=new Uint8Array(0),r=0;for(;;){const{done:a,value:o}=await n.read();if(a)return s.subarray(0,r);if(r+o.length>t)throw n.cancel().catch(()=>{}),new Wt("broken_protocol",`${e} has more than ${t} bytes`);if(r===0)s=o;else{if(r+o.length>s.length){const l=new Uint8Array(Math.min(t,Math.max(2*s.length,r+o.length)));l.set(s.subarray(0,r)),s=l}s.set(o,r)}r+=o.length}}async function bf(i,t){let e="",n=`${t.slice(0,200)} answered ${i.status}`,s=1e3*(Number(i.headers.get("Retry-After"))||0);try{const{error:r}=JSON.parse(new TextDecoder().decode(await xu(i,wf,t)));e=String(r.code),n=`the server says: ${String(r.text)}`,s=Number(r.retry_after_ms)||s}catch{}return new so(Tf(i.status),n,s,i.status,e)}function Tf(i){return i===401||i===403?"refused":i===429||i>=500?"overloaded":i===400?"out_of_range":"server_failed"}function cc(i,t,e){if(!Array.isArray(i)||i.length!==t||!i.every(n=>typeof n=="number"))throw Bt(`heights whose ${e} are not ${t} numbers`);return i}function Af(i,t,e,n,s){let r;try{r=JSON.parse(new TextDecoder().decode(i))??{}}catch(c){throw Bt(`heights that are no JSON: ${c.message}`)}const a=Int32Array.from(cc(r.heights,t,"heights"));let o=null;if(e){if(!Array.isArray(r.looks)||r.looks.length!==t)throw Bt(`heights without ${t} looks`);o=Uint8Array.from(r.looks,c=>{const h=s.indexOf(c);if(h<0)throw Bt("a look that the world does not list");return h})}let l=null;return n.length>0&&(l=new Float32Array(t*n.length),n.forEach((c,h)=>{cc(r.fields?.[c],t,c).forEach((u,d)=>{l[d*n.length+h]=u})})),{heightsFx:a,looks:o,values:l}}function Su({lod:i,x:t,z:e,n}){return n===1?`${i}/${t}/${e}`:`${i}/${t}/${e}/${n}x${n}`}const Rf=[[4,6],[2,3]],Cf=1.5;function hc(i,t){for(let e=i.z;e<i.z+i.n;++e)for(let n=i.x;n<i.x+i.n;++n)t(n,e)}function Lf(i){const t=i.n/2;return[0,1,2,3].map(e=>({lod:i.lod,x:i.x+t*(e&1),z:i.z+t*(e>>1),n:t}))}function Pf(i,t,e){const n=new Map;t.forEachColumn((r,a,o)=>{if(!e(r,a,o))return;const l=If(i,r,a,o);n.set(Su(l),l)});const s=r=>Df(i,r);return[...n.values()].map(r=>({tile:r,at:s(r)})).sort((r,a)=>r.at-a.at).map(({tile:r})=>r)}function If(i,t,e,n){const s=32*2**t;for(const[r,a]of Rf){const o={lod:t,x:Math.floor(e/r)*r,z:Math.floor(n/r)*r,n:r},l=Math.max(o.x-i.centre.x/s,i.centre.x/s-(o.x+r),0),c=Math.max(o.z-i.centre.z/s,i.centre.z/s-(o.z+r),0);if(Math.max(l,c)>=a)return o}return{lod:t,x:e,z:n,n:1}}function Df(i,{lod:t,x:e,z:n,n:s}){const r=32*2**t,a=(e+s/2)*r-i.centre.x,o=(n+s/2)*r-i.centre.z,l=Math.hypot(a,o),c=i.direction??{x:0,z:0};return c.x*a+c.z*o<0?l*Cf:l}function Rn(i){throw Bt(`a world whose ${i} is missing or wrong`)}function $e(i,t){const e=i[t];return typeof e=="number"&&Number.isSafeInteger(e)?e:Rn(t)}function bs(i,t){const e=i[t];return typeof e=="string"?e:Rn(t)}function ro(i,t){const e=i[t];return Array.isArray(e)?e:Rn(t)}function Mu(i,t){const e=i[t];return typeof e=="object"&&e!==null?e:Rn(t)}function uc(i,t){const e=bs(i,t);return/^[0-9a-f]{32}$/.test(e)?e:Rn(t)}function dc(i,t){return ro(i,t).map(e=>typeof e=="string"?e:Rn(t))}function Nf(i){const t=i??{},e=/^#([0-9a-f]{6})$/.exec(bs(t,"colour")),n=bs(t,"phase");return(e===null||!["gas","liquid","solid"].includes(n))&&Rn("materials"),{id:$e(t,"id"),name:bs(t,"name"),colour:parseInt(e[1],16),phase:n}}function fc(i,t){const e=Mu(i,t);return{chunks:$e(e,"chunks_per_second"),bytes:$e(e,"bytes_per_second"),requests:$e(e,"requests_per_second"),burstMs:$e(e,"burst_ms")}}function Uf(i){(typeof i!="object"||i===null)&&Rn("JSON");const t=i,e=Mu(t,"limits"),[n,s,r]=ro(t,"spawn");return[n,s,r].every(Number.isSafeInteger)||Rn("spawn"),$e(t,"chunk_size")!==32&&Rn("chunk_size"),{fingerprint:uc(t,"fingerprint"),storeId:uc(t,"store_id"),codec:$e(t,"codec"),materials:ro(t,"materials").map(Nf),minY:$e(t,"min_y"),maxY:$e(t,"max_y"),spawn:{x:n,y:s,z:r},limits:{frameBytes:0,requestsInFlight:0,heightsPerRequest:$e(e,"heights_per_request"),viewHorizontalRadius:$e(e,"view_horizontal_radius"),viewVerticalRadius:$e(e,"view_vertical_radius"),viewChunks:$e(e,"view_chunks"),windowBytes:0,idleTimeoutMs:0,sessionRates:fc(e,"session"),addressRates:fc(e,"address"),viewHorizon:!0},server:bs(t,"server"),looks:dc(t,"looks"),fields:dc(t,"fields")}}const pc=65538,Ff=4<<20,mc=6,Of=1<<20,kf=700;function ha(i,t,e){return`${i}/${t}/${e}`}class Bf extends gu{base;getter;abort=new AbortController;tasks=[];running=new Map;asked=[];askedRunning=0;columns=new Map;completeToTell=!1;holdTimer;debts=new WeakMap;owedBytes=0;constructor(t,e){super(t),this.base=e.href.replace(/\/$/,""),this.getter={fetch:t.fetch??globalThis.fetch.bind(globalThis),token:t.token},this.attempt()}get chunksUrl(){return`${this.base}/v1/${this.world.fingerprint}/${this.world.codec}`}async get(t,e,n=this.abort.signal,s="GET"){const r=performance.now();++this.stats.requests;const a=await Ef(this.getter,t,e,n,s);return this.stats.latencyMs=performance.now()-r,this.stats.receivedBytes+=a.length,a}attempt(){const{signal:t}=this.abort=new AbortController;this.getWorld().then(e=>{t.aborted||this.joined(e)},e=>{t.aborted||this.fail(e)})}async getWorld(){const t=await this.get(`${this.base}/v1/world`,Ff);try{return Uf(JSON.parse(new TextDecoder().decode(t)))}catch(e){throw e instanceof Wt?e:Bt(`a world that is no JSON: ${e.message}`)}}worldKnown(t){t||this.columns.clear(),this.pump()}fail(t){this.halt(),this.lost(t)}halt(){this.abort.abort(),this.tasks=[];for(const t of this.running.values())t.abort();this.running.clear(),clearTimeout(this.holdTimer),this.holdTimer=void 0,this.completeToTell=!1}stopped(){this.halt();for(const t of this.asked.splice(0))t()}viewApplied(){const{view:t,shape:e}=this.tracker;this.completeToTell=t!==null,this.tasks=[];for(const[s,r]of this.columns){const[a,o,l]=s.split("/").map(Number),c=e?.rows(a,o,l);(c?.first!==r.first||c.last!==r.last)&&this.columns.delete(s)}const n=new Set;for(const[s,r]of this.running){if(!("tile"in s))continue;let a=!1;hc(s.tile,(o,l)=>{e?.hasColumn(s.tile.lod,o,l)&&(a=!0,n.add(ha(s.tile.lod,o,l)))}),a||(this.running.delete(s),r.abort())}t!==null&&e!==null&&(this.tasks=Pf(t,e,(s,r,a)=>{const o=ha(s,r,a);return!this.columns.has(o)&&!n.has(o)}).map(s=>({tile:s}))),this.pump()}pump(){if(!this.connected)return;const t=Math.max(1,Math.min(mc,this.options.requestsAtOnce??mc)),e=()=>this.askedRunning+this.running.size>=t;for(;!e()&&this.asked.length>0;)this.asked.shift()();const n=this.options.windowBytes??Of;for(;!e()&&this.holdTimer===void 0&&this.owedBytes<n;){const s=this.tasks.shift();if(s===void 0)break;const r=new AbortController;this.running.set(s,r),this.run(s,r)}this.completeToTell&&this.tasks.length===0&&this.running.size===0&&(this.completeToTell=!1,this.tellComplete())}async run(t,e){try{const n="tile"in t?Su(t.tile):Tn(t.key),s="tile"in t?oc:pc,r=await this.get(`${this.chunksUrl}/${n}`,s,e.signal);if(e.signal.aborted)return;this.backoff.reset(),this.stats.chunkBytes+=r.length,"tile"in t?this.takeTile(t.tile,r):this.give({key:t.key,revision:0n,hash:null,payload:r.slice(),material:Tr(r)})}catch(n){if(e.signal.aborted)return;if(!(n instanceof Wt))throw n;this.running.delete(t),this.failTask(t,n)}this.running.delete(t),this.pump()}takeTile(t,e){const n=t.n===1?[e]:yf(e,t.n);let s=0;hc(t,(r,a)=>{const o=n[s++],l=this.tracker.shape?.rows(t.lod,r,a);if(l===void 0||l.last<l.first||!this.connected)return;const c=Mf(o,t.lod);this.columns.set(ha(t.lod,r,a),l);for(const h of c){const u=Math.min(l.last,h.firstY+h.count-1),d=Math.max(l.first,h.firstY);if(d>u)continue;const f=Tr(h.payload);for(let _=d;_<=u&&this.connected;++_)this.give({key:{lod:t.lod,x:r,y:_,z:a},revision:0n,hash:null,payload:new Uint8Array(h.payload),material:f})}})}give(t){!this.deliver(t)||!this.options.manualCredit||(this.debts.set(t,t.payload.length),this.owedBytes+=t.payload.length)}taken(t){const e=this.debts.get(t);e!==void 0&&(this.debts.delete(t),this.owedBytes-=e,this.pump())}failTask(t,e){if(e.kind==="overloaded"){this.tasks.unshift(t);const n=this.backoff.next(e.retryAfterMs);if(n===null){this.fail(e);return}this.holdTimer??=setTimeout(()=>{this.holdTimer=void 0,this.pump()},n);return}if(e instanceof so&&e.status===404){this.fail(new Wt("disconnected",e.message));return}if(e instanceof so&&e.code==="too_large"&&"tile"in t){this.tasks.unshift(...this.smaller(t.tile));return}if(e.kind==="out_of_range"||e.kind==="broken_protocol"){this.emit("error",e);return}this.fail(e)}smaller(t){if(t.n>1)return Lf(t).map(o=>({tile:o}));const{lod:e,x:n,z:s}=t,r=this.tracker.shape?.rows(e,n,s),a=[];if(r===void 0)return a;for(let o=r.first;o<=r.last;++o)a.push({key:{lod:e,x:n,y:o,z:s}});return a}ask(t,e){return new Promise((n,s)=>{if(this.isClosed)throw this.closedError();this.asked.push(()=>{if(this.isClosed){s(this.closedError());return}++this.askedRunning,this.get(t(),e).then(n,s).finally(()=>{--this.askedRunning,this.pump()})}),this.pump()})}async getChunk(t){mu(t);const e=new Uint8Array(await this.ask(()=>`${this.chunksUrl}/${Tn(t)}`,pc));return{key:{...t},revision:0n,hash:null,payload:e,material:Tr(e)}}async getPlaces(t,{looks:e=!1,fields:n=[]}={}){const s={heightsFx:new Int32Array(t.length),looks:e?new Uint8Array(t.length):null,values:n.length>0?new Float32Array(t.length*n.length):null},r=[...e?["&looks=1"]:[],...n.length>0?[`&fields=${n.map(encodeURIComponent).join(",")}`]:[]].join("");for(let a=0;a<t.length;){let o="",l=a;for(;l<t.length&&o.length<kf;++l)o+=`${o===""?"":";"}${t[l].x},${t[l].z}`;const c=await this.ask(()=>`${this.base}/v1/heights?columns=${o}${r}`,oc),h=Af(c,l-a,e,n,this.world.looks);s.heightsFx.set(h.heightsFx,a),h.looks!==null&&s.looks.set(h.looks,a),h.values!==null&&s.values.set(h.values,a*n.length),a=l}return s}async ping(){if(!this.connected)throw new Wt("disconnected","ping: the client is not connected");const t=performance.now();return await this.get(`${this.base}/v1/world`,0,this.abort.signal,"HEAD"),this.stats.latencyMs=performance.now()-t}}const gc=200;class zf{constructor(t){this.maxBytes=t}kept=new Map;bytes=0;put(t,e){this.erase(t),this.kept.set(t,{...e,payload:e.payload.slice()}),this.bytes+=e.payload.length+gc;for(const n of this.kept.keys()){if(this.bytes<=this.maxBytes)break;this.erase(n)}}find(t){return this.kept.get(t)}erase(t){const e=this.kept.get(t);e!==void 0&&(this.kept.delete(t),this.bytes-=e.payload.length+gc)}clear(){this.kept.clear(),this.bytes=0}entries(){return this.kept}}const Ts=4,_c=12,vc=262144;class xc{held=new Uint8Array(0);count=0;push(t,e){let n=t;for(;n.length>0;){if(this.count===0){const a=ua(n);if(a!==null&&a<=n.length){e(n.subarray(0,a)),n=n.subarray(a);continue}}const s=this.count<Ts?Ts:ua(this.held),r=Math.min(s-this.count,n.length);if(this.keep(n.subarray(0,r)),n=n.subarray(r),this.count>=Ts&&this.count===ua(this.held)){const a=this.held.subarray(0,this.count);this.count=0,e(a)}}}keep(t){if(this.count+t.length>this.held.length){const e=new Uint8Array(Math.max(1024,2*this.held.length,this.count+t.length));e.set(this.held.subarray(0,this.count)),this.held=e}this.held.set(t,this.count),this.count+=t.length}}function ua(i){if(i.length<Ts)return null;const t=(i[0]|i[1]<<8|i[2]<<16)+i[3]*16777216+Ts;if(t<_c||t>vc)throw Bt(`a frame of ${t} bytes; frames have ${_c} to ${vc}`);return t}const Gf=["none","version","malformed","unexpected","too_large","too_many_requests","out_of_range","cancelled","unsupported","unauthorized","overloaded","timeout","duplicate_id","internal","forbidden"],Hf=["unspecified","connection","request","repeated_request","view","view_chunk","ping"],Vf=["gas","liquid","solid"],Wf={9:Kf,10:i=>({kind:"chunk",id:i.u32(0),key:Hs(i,1),revision:i.u64(2),hash:Or(i,3),codec:i.u8(4),payload:i.bytesOf(5)}),11:i=>({kind:"unchanged",id:i.u32(0),key:Hs(i,1),revision:i.u64(2),hash:Or(i,3)}),12:Zf,13:Jf,14:i=>({kind:"error",code:Gf[i.u16(0)]??"unknown",text:i.text(1),requestId:i.u32(2),retryAfterMs:i.u32(3),about:Hf[i.u8(4)]??"unspecified",repeatedId:i.u32(5),viewNumber:i.u32(6),chunk:i.struct(7,16)===0?null:Hs(i,7)}),15:i=>({kind:"edit_result",id:i.u32(0),revision:i.u64(1)}),16:i=>({kind:"edit_broadcast",key:Hs(i,0),revision:i.u64(1)}),17:i=>({kind:"pong",nonce:i.u64(0)}),18:i=>({kind:"go_away",reason:i.text(0),retryAfterMs:i.u32(1)}),19:i=>({kind:"view_complete",number:i.u32(0)})};function Xf(i){const t=new _f(i).root(),e=t.u8(0),n=Wf[e],s=t.table(1);if(n===void 0||s===null)throw Bt(`a message of kind ${e}, which no server sends`);return n(s)}function Hs(i,t){const e=i.struct(t,16);if(e===0)throw Bt("a chunk without a key");return{lod:i.data.getUint8(e+12),x:i.data.getInt32(e,!0),y:i.data.getInt32(e+4,!0),z:i.data.getInt32(e+8,!0)}}function Sc(i,t){const e=n=>n.toString(16).padStart(8,"0");return e(i.getUint32(t+4,!0))+e(i.getUint32(t,!0))}function Or(i,t){const e=i.struct(t,16);return e===0?"0".repeat(32):Sc(i.data,e+8)+Sc(i.data,e)}function ao(i,t){const e=Number(i);if(!Number.isSafeInteger(e))throw Bt(`${t} ${i}, which is beyond any world`);return e}function qf(i,t,e){const n=i.struct(t,24);if(n===0)return{x:0,y:0,z:0};const s=r=>ao(i.data.getBigInt64(n+8*r,!0),e);return{x:s(0),y:s(1),z:s(2)}}function Mc(i){return i===null?null:{chunks:Number(i.u64(0)),bytes:Number(i.u64(1)),requests:Number(i.u64(2)),burstMs:i.u32(3)}}function $f(i){if(i===null)throw Bt("a Welcome without limits");return{frameBytes:i.u32(0),requestsInFlight:i.u32(1),heightsPerRequest:i.u32(2),viewHorizontalRadius:i.u16(3),viewVerticalRadius:i.u16(4),viewChunks:i.u32(5),windowBytes:Number(i.u64(6)),idleTimeoutMs:i.u32(7),sessionRates:Mc(i.table(8)),addressRates:Mc(i.table(9)),viewHorizon:i.bool(10)}}function Yf(i){return{id:i.u16(0),name:i.text(1),colour:i.u32(2),phase:Vf[i.u8(3)]??"solid"}}function Kf(i){const t=i.u16(4);if(t!==32)throw Bt(`a Welcome with chunks of ${t} voxels; this client knows 32`);const e={fingerprint:Or(i,2),storeId:Or(i,3),codec:i.u8(1),materials:i.tables(5,Yf),minY:ao(i.i64(6),"min_y"),maxY:ao(i.i64(7),"max_y"),spawn:qf(i,8,"a spawn at"),limits:$f(i.table(9)),server:i.text(10),looks:i.texts(11),fields:i.texts(12)};return{kind:"welcome",protocol:i.u16(0),world:e}}function Zf(i){const{at:t,count:e}=i.vector(4,12),n=[];for(let s=0;s<e;++s){const r=t+12*s;n.push({firstY:i.data.getInt32(r,!0),lastY:i.data.getInt32(r+4,!0),material:i.data.getUint16(r+8,!0)})}return{kind:"uniform_column",x:i.i32(0),z:i.i32(1),lod:i.u8(2),revision:i.u64(3),runs:n}}function Jf(i){const t=i.vector(1,4),e=i.vector(3,4);return{kind:"heights",id:i.u32(0),heightsFx:Int32Array.from({length:t.count},(n,s)=>i.data.getInt32(t.at+4*s,!0)),looks:i.bytesOf(2),values:Float32Array.from({length:e.count},(n,s)=>i.data.getFloat32(e.at+4*s,!0))}}const da=2,En=4,Bn=4,Qf=4,si=new Int32Array(2),yc=new Float32Array(si.buffer),wc=new Float64Array(si.buffer),Vs=new Uint16Array(new Uint8Array([1,0]).buffer)[0]===1;var oo;(function(i){i[i.UTF8_BYTES=1]="UTF8_BYTES",i[i.UTF16_STRING=2]="UTF16_STRING"})(oo||(oo={}));class kr{constructor(t){this.bytes_=t,this.position_=0,this.text_decoder_=new TextDecoder}static allocate(t){return new kr(new Uint8Array(t))}clear(){this.position_=0}bytes(){return this.bytes_}position(){return this.position_}setPosition(t){this.position_=t}capacity(){return this.bytes_.length}readInt8(t){return this.readUint8(t)<<24>>24}readUint8(t){return this.bytes_[t]}readInt16(t){return this.readUint16(t)<<16>>16}readUint16(t){return this.bytes_[t]|this.bytes_[t+1]<<8}readInt32(t){return this.bytes_[t]|this.bytes_[t+1]<<8|this.bytes_[t+2]<<16|this.bytes_[t+3]<<24}readUint32(t){return this.readInt32(t)>>>0}readInt64(t){return BigInt.asIntN(64,BigInt(this.readUint32(t))+(BigInt(this.readUint32(t+4))<<BigInt(32)))}readUint64(t){return BigInt.asUintN(64,BigInt(this.readUint32(t))+(BigInt(this.readUint32(t+4))<<BigInt(32)))}readFloat32(t){return si[0]=this.readInt32(t),yc[0]}readFloat64(t){return si[Vs?0:1]=this.readInt32(t),si[Vs?1:0]=this.readInt32(t+4),wc[0]}writeInt8(t,e){this.bytes_[t]=e}writeUint8(t,e){this.bytes_[t]=e}writeInt16(t,e){this.bytes_[t]=e,this.bytes_[t+1]=e>>8}writeUint16(t,e){this.bytes_[t]=e,this.bytes_[t+1]=e>>8}writeInt32(t,e){this.bytes_[t]=e,this.bytes_[t+1]=e>>8,this.bytes_[t+2]=e>>16,this.bytes_[t+3]=e>>24}writeUint32(t,e){this.bytes_[t]=e,this.bytes_[t+1]=e>>8,this.bytes_[t+2]=e>>16,this.bytes_[t+3]=e>>24}writeInt64(t,e){this.writeInt32(t,Number(BigInt.asIntN(32,e))),this.writeInt32(t+4,Number(BigInt.asIntN(32,e>>BigInt(32))))}writeUint64(t,e){this.writeUint32(t,Number(BigInt.asUintN(32,e))),this.writeUint32(t+4,Number(BigInt.asUintN(32,e>>BigInt(32))))}writeFloat32(t,e){yc[0]=e,this.writeInt32(t,si[0])}writeFloat64(t,e){wc[0]=e,this.writeInt32(t,si[Vs?0:1]),this.writeInt32(t+4,si[Vs?1:0])}getBufferIdentifier(){if(this.bytes_.length<this.position_+En+Bn)throw new Error("FlatBuffers: ByteBuffer is too short to contain an identifier.");let t="";for(let e=0;e<Bn;e++)t+=String.fromCharCode(this.readInt8(this.position_+En+e));return t}__offset(t,e){const n=t-this.readInt32(t);return e<this.readInt16(n)?this.readInt16(n+e):0}__union(t,e){return t.bb_pos=e+this.readInt32(e),t.bb=this,t}__string(t,e){t+=this.readInt32(t);const n=this.readInt32(t);t+=En;const s=this.bytes_.subarray(t,t+n);return e===oo.UTF8_BYTES?s:this.text_decoder_.decode(s)}__union_with_string(t,e){return typeof t=="string"?this.__string(e):this.__union(t,e)}__indirect(t){return t+this.readInt32(t)}__vector(t){return t+this.readInt32(t)+En}__vector_len(t){return this.readInt32(t+this.readInt32(t))}__has_identifier(t){if(t.length!=Bn)throw new Error("FlatBuffers: file identifier must be length "+Bn);for(let e=0;e<Bn;e++)if(t.charCodeAt(e)!=this.readInt8(this.position()+En+e))return!1;return!0}createScalarList(t,e){const n=[];for(let s=0;s<e;++s){const r=t(s);r!==null&&n.push(r)}return n}createObjList(t,e){const n=[];for(let s=0;s<e;++s){const r=t(s);r!==null&&n.push(r.unpack())}return n}}class fl{constructor(t){this.minalign=1,this.vtable=null,this.vtable_in_use=0,this.isNested=!1,this.object_start=0,this.vtables=[],this.vector_num_elems=0,this.force_defaults=!1,this.string_maps=null,this.text_encoder=new TextEncoder;let e;t?e=t:e=1024,this.bb=kr.allocate(e),this.space=e}clear(){this.bb.clear(),this.space=this.bb.capacity(),this.minalign=1,this.vtable=null,this.vtable_in_use=0,this.isNested=!1,this.object_start=0,this.vtables=[],this.vector_num_elems=0,this.force_defaults=!1,this.string_maps=null}forceDefaults(t){this.force_defaults=t}dataBuffer(){return this.bb}asUint8Array(){return this.bb.bytes().subarray(this.bb.position(),this.bb.position()+this.offset())}prep(t,e){t>this.minalign&&(this.minalign=t);const n=~(this.bb.capacity()-this.space+e)+1&t-1;for(;this.space<n+t+e;){const s=this.bb.capacity();this.bb=fl.growByteBuffer(this.bb),this.space+=this.bb.capacity()-s}this.pad(n)}pad(t){for(let e=0;e<t;e++)this.bb.writeInt8(--this.space,0)}writeInt8(t){this.bb.writeInt8(this.space-=1,t)}writeInt16(t){this.bb.writeInt16(this.space-=2,t)}writeInt32(t){this.bb.writeInt32(this.space-=4,t)}writeInt64(t){this.bb.writeInt64(this.space-=8,t)}writeFloat32(t){this.bb.writeFloat32(this.space-=4,t)}writeFloat64(t){this.bb.writeFloat64(this.space-=8,t)}addInt8(t){this.prep(1,0),this.writeInt8(t)}addInt16(t){this.prep(2,0),this.writeInt16(t)}addInt32(t){this.prep(4,0),this.writeInt32(t)}addInt64(t){this.prep(8,0),this.writeInt64(t)}addFloat32(t){this.prep(4,0),this.writeFloat32(t)}addFloat64(t){this.prep(8,0),this.writeFloat64(t)}addFieldInt8(t,e,n){(this.force_defaults||e!=n)&&(this.addInt8(e),this.slot(t))}addFieldInt16(t,e,n){(this.force_defaults||e!=n)&&(this.addInt16(e),this.slot(t))}addFieldInt32(t,e,n){(this.force_defaults||e!=n)&&(this.addInt32(e),this.slot(t))}addFieldInt64(t,e,n){(this.force_defaults||e!==n)&&(this.addInt64(e),this.slot(t))}addFieldFloat32(t,e,n){(this.force_defaults||e!=n)&&(this.addFloat32(e),this.slot(t))}addFieldFloat64(t,e,n){(this.force_defaults||e!=n)&&(this.addFloat64(e),this.slot(t))}addFieldOffset(t,e,n){(this.force_defaults||e!=n)&&(this.addOffset(e),this.slot(t))}addFieldStruct(t,e,n){e!=n&&(this.nested(e),this.slot(t))}nested(t){if(t!=this.offset())throw new TypeError("FlatBuffers: struct must be serialized inline.")}notNested(){if(this.isNested)throw new TypeError("FlatBuffers: object serialization must not be nested.")}slot(t){this.vtable!==null&&(this.vtable[t]=this.offset())}offset(){return this.bb.capacity()-this.space}static growByteBuffer(t){const e=t.capacity();if(e&3221225472)throw new Error("FlatBuffers: cannot grow buffer beyond 2 gigabytes.");const n=e<<1,s=kr.allocate(n);return s.setPosition(n-e),s.bytes().set(t.bytes(),n-e),s}addOffset(t){this.prep(En,0),this.writeInt32(this.offset()-t+En)}startObject(t){this.notNested(),this.vtable==null&&(this.vtable=[]),this.vtable_in_use=t;for(let e=0;e<t;e++)this.vtable[e]=0;this.isNested=!0,this.object_start=this.offset()}endObject(){if(this.vtable==null||!this.isNested)throw new Error("FlatBuffers: endObject called without startObject");this.addInt32(0);const t=this.offset();let e=this.vtable_in_use-1;for(;e>=0&&this.vtable[e]==0;e--);const n=e+1;for(;e>=0;e--)this.addInt16(this.vtable[e]!=0?t-this.vtable[e]:0);const s=2;this.addInt16(t-this.object_start);const r=(n+s)*da;this.addInt16(r);let a=0;const o=this.space;t:for(e=0;e<this.vtables.length;e++){const l=this.bb.capacity()-this.vtables[e];if(r==this.bb.readInt16(l)){for(let c=da;c<r;c+=da)if(this.bb.readInt16(o+c)!=this.bb.readInt16(l+c))continue t;a=this.vtables[e];break}}return a?(this.space=this.bb.capacity()-t,this.bb.writeInt32(this.space,a-t)):(this.vtables.push(this.offset()),this.bb.writeInt32(this.bb.capacity()-t,this.offset()-t)),this.isNested=!1,t}finish(t,e,n){const s=n?Qf:0;if(e){const r=e;if(this.prep(this.minalign,En+Bn+s),r.length!=Bn)throw new TypeError("FlatBuffers: file identifier must be length "+Bn);for(let a=Bn-1;a>=0;a--)this.writeInt8(r.charCodeAt(a))}this.prep(this.minalign,En+s),this.addOffset(t),s&&this.addInt32(this.bb.capacity()-this.space),this.bb.setPosition(this.space)}finishSizePrefixed(t,e){this.finish(t,e,!0)}requiredField(t,e){const n=this.bb.capacity()-t,s=n-this.bb.readInt32(n);if(!(e<this.bb.readInt16(s)&&this.bb.readInt16(s+e)!=0))throw new TypeError("FlatBuffers: field "+e+" must be set")}startVector(t,e,n){this.notNested(),this.vector_num_elems=e,this.prep(En,t*e),this.prep(n,t*e)}endVector(){return this.writeInt32(this.vector_num_elems),this.offset()}createSharedString(t){if(!t)return 0;if(this.string_maps||(this.string_maps=new Map),this.string_maps.has(t))return this.string_maps.get(t);const e=this.createString(t);return this.string_maps.set(t,e),e}createString(t){if(t==null)return 0;let e;return t instanceof Uint8Array?e=t:e=this.text_encoder.encode(t),this.addInt8(0),this.startVector(1,e.length,1),this.bb.setPosition(this.space-=e.length),this.bb.bytes().set(e,this.space),this.endVector()}createByteVector(t){return t==null?0:(this.startVector(1,t.length,1),this.bb.setPosition(this.space-=t.length),this.bb.bytes().set(t,this.space),this.endVector())}createObjectOffset(t){return t===null?0:typeof t=="string"?this.createString(t):t.pack(this)}createObjectOffsetList(t){const e=[];for(let n=0;n<t.length;++n){const s=t[n];if(s!==null)e.push(this.createObjectOffset(s));else throw new TypeError("FlatBuffers: Argument for createObjectOffsetList cannot contain null.")}return e}createStructOffsetList(t,e){return e(this,t.length),this.createObjectOffsetList(t.slice().reverse()),this.endVector()}}const yu=40,wu=32,Eu=16,Ec=128;function ns(i,t){const e=new fl(256),n=t(e);return e.startObject(2),e.addFieldOffset(1,n,0),e.addFieldInt8(0,i,0),e.finishSizePrefixed(e.endObject()),e.asUint8Array()}function Cs(i,t,e,n,s){i.startVector(e,t.length,n);for(let r=t.length-1;r>=0;--r)i.prep(n,e),s(t[r]);return i.endVector()}function bu(i,t){i.writeInt64(BigInt(`0x${t.slice(0,16)}`)),i.writeInt64(BigInt(`0x${t.slice(16)}`))}function Tu(i,t){i.pad(3),i.writeInt8(t.lod),i.writeInt32(t.z),i.writeInt32(t.y),i.writeInt32(t.x)}function jf(i){return ns(1,t=>{t.startVector(1,i.codecs.length,1);for(let r=i.codecs.length-1;r>=0;--r)t.addInt8(i.codecs[r]);const e=t.endVector(),n=t.createString(i.token),s=t.createString(i.client);return t.startObject(6),t.addFieldInt64(5,BigInt(i.windowBytes),0n),t.addFieldOffset(4,s,0),t.addFieldOffset(3,n,0),t.addFieldOffset(2,e,0),t.addFieldInt16(1,i.protocolMax,0),t.addFieldInt16(0,i.protocolMin,0),t.endObject()})}function bc(i,t,e){return ns(2,n=>{const s=Cs(n,e,wu,8,a=>{bu(n,a.hash),Tu(n,a.key)}),r=Cs(n,i.rings??[],4,2,a=>{n.writeInt16(a.radius),n.pad(1),n.writeInt8(a.lod)});return n.startObject(8),n.prep(8,24),n.writeInt64(BigInt(i.centre.z)),n.writeInt64(BigInt(i.centre.y)),n.writeInt64(BigInt(i.centre.x)),n.addFieldStruct(0,n.offset(),0),i.direction!==void 0&&(n.prep(4,12),n.writeFloat32(i.direction.z),n.writeFloat32(i.direction.y),n.writeFloat32(i.direction.x),n.addFieldStruct(1,n.offset(),0)),n.addFieldInt16(2,i.horizontalRadius,0),n.addFieldInt16(3,i.verticalRadius,0),n.addFieldOffset(4,r,0),n.addFieldOffset(5,s,0),n.addFieldInt32(6,t,0),n.addFieldInt8(7,i.horizon?1:0,0),n.endObject()})}function tp(i){return ns(3,t=>{const e=Cs(t,i,yu,8,n=>{bu(t,n.known??"0".repeat(32)),t.pad(3),t.writeInt8(n.known===null?0:1),Tu(t,n.key),t.writeInt32(n.id)});return t.startObject(1),t.addFieldOffset(0,e,0),t.endObject()})}function ep(i,t,e,n){return ns(5,s=>{const r=Cs(s,t,Eu,8,o=>{s.writeInt64(BigInt(o.z)),s.writeInt64(BigInt(o.x))}),a=Cs(s,n,1,1,o=>s.writeInt8(o));return s.startObject(4),s.addFieldOffset(3,a,0),s.addFieldOffset(1,r,0),s.addFieldInt32(0,i,0),s.addFieldInt8(2,e?1:0,0),s.endObject()})}function np(i){return ns(6,t=>(t.startObject(1),t.addFieldInt64(0,BigInt(i),0n),t.endObject()))}function ip(i){return ns(8,t=>(t.startObject(1),t.addFieldInt64(0,BigInt(i),0n),t.endObject()))}class sp{tokens=1/0;most=1/0;perMs=0;at=0;heldUntil=0;begin(t,e){const n=t!==null&&t.requests>0;this.perMs=n?t.requests/1e3:0,this.tokens=this.most=n?Math.max(1,Math.floor(t.requests*t.burstMs/1e3)):1/0,this.at=e,this.heldUntil=0}refused(t,e){this.heldUntil=Math.max(this.heldUntil,e+t)}wait(t){this.tokens=Math.min(this.most,this.tokens+(t-this.at)*this.perMs),this.at=t;const e=this.tokens>=1?0:(1-this.tokens)/this.perMs;return Math.ceil(Math.max(e,this.heldUntil-t,0))}take(){this.tokens-=1}}class rp{inFlight=new Map;waiting=[];lastId=0;add(t){this.waiting.push(t)}get inFlightCount(){return this.inFlight.size}next(){const t=this.waiting.shift();if(t===void 0)return null;do this.lastId=this.lastId%4294967295+1;while(this.inFlight.has(this.lastId));return this.inFlight.set(this.lastId,t),{id:this.lastId,request:t}}peek(){return this.waiting[0]}find(t){return this.inFlight.get(t)}take(t){const e=this.inFlight.get(t);return this.inFlight.delete(t),e}putBack(t){const e=this.take(t);e!==void 0&&this.waiting.unshift(e)}putAllBack(){this.waiting=[...this.inFlight.values(),...this.waiting],this.inFlight.clear()}failAll(t){this.putAllBack();const e=this.waiting;this.waiting=[];for(const n of e)n.reject(t)}}const fa=1,Tc=4,Ac=4096,ap=1<<20,op=16<<20,lp=1e4,Rc=2e4,cp=6e4,hp=8192,up=2**40;class dp extends gu{constructor(t,e){super(t),this.open=e;for(const[n,s]of[["token",t.token],["clientName",t.clientName]]){const r=new TextEncoder().encode(s??"").length;if(r>Ac)throw new Wt("out_of_range",`${n} has ${r} bytes; at most ${Ac} are allowed`)}this.cache=new zf(t.keepBytes??op),this.attempt()}transport=null;connection=0;reader=new xc;requests=new rp;pace=new sp;cache;pings=new Map;lastNonce=0;debts=new WeakMap;takenBytes=0;creditedBytes=0;viewNumber=0;viewToSend=!1;completeToTell=!1;refetching=new Set;leaving=null;heardAt=0;deadline;heartbeat;sendTimer;uniform=new Map;attempt(){const t=++this.connection,e=()=>t===this.connection&&!this.isClosed;this.reader=new xc,this.takenBytes=this.creditedBytes=0,this.leaving=null;const n=this.options.connectTimeoutMs??lp;this.deadline=setTimeout(()=>{this.drop(new Wt("timed_out",`${this.options.url} did not answer within ${n/1e3} s`))},n),this.transport=this.open({opened:()=>e()&&this.sayHello(),received:s=>e()&&this.receive(s,e),ended:s=>e()&&this.drop(this.leaving??s)})}sayHello(){this.send(jf({protocolMin:fa,protocolMax:fa,codecs:[Tc],token:this.options.token??"",client:this.options.clientName??"talus-client for JavaScript",windowBytes:this.options.windowBytes??ap}))}send(t){this.stats.sentBytes+=t.length,this.transport?.send(t)}drop(t){if(this.disconnect(),this.connected)for(const n of this.takePings())n.reject(t);this.lost(t)}disconnect(){++this.connection,clearTimeout(this.deadline),clearInterval(this.heartbeat),clearTimeout(this.sendTimer),this.sendTimer=void 0,this.transport?.close(),this.transport=null,this.refetching.clear(),this.completeToTell=!1,this.viewToSend=!1,this.requests.putAllBack()}takePings(){const t=[...this.pings.values()];return this.pings.clear(),t}stopped(){this.disconnect();const t=this.closedError();for(const e of this.takePings())e.reject(t);this.requests.failAll(t),this.cache.clear()}receive(t,e){this.stats.receivedBytes+=t.length,this.heardAt=performance.now();try{this.reader.push(t,n=>{e()&&this.handle(Xf(n),n.length)})}catch(n){if(!(n instanceof Wt))throw n;e()&&this.drop(n)}}handle(t,e){if(!this.connected){if(t.kind==="welcome")this.handleWelcome(t);else if(t.kind==="error")this.handleFatal(t);else if(t.kind==="go_away")this.handleGoAway(t);else throw Bt(`${t.kind} before Welcome`);return}switch(t.kind){case"chunk":return this.handleChunk(t,e);case"unchanged":return this.handleUnchanged(t);case"uniform_column":return this.handleUniformColumn(t);case"view_complete":return this.handleViewComplete(t);case"heights":return this.handleHeights(t);case"error":return this.handleError(t);case"edit_broadcast":return void(this.tracker.has(t.key)&&this.refetch(t.key));case"pong":return this.handlePong(t);case"go_away":return this.handleGoAway(t);default:throw Bt(`an unexpected ${t.kind}`)}}handleWelcome({protocol:t,world:e}){if(t!==fa||e.codec!==Tc)throw Bt(`a Welcome for protocol ${t} and codec ${e.codec}, which were not offered`);clearTimeout(this.deadline),this.pace.begin(e.limits.sessionRates,performance.now()),this.joined(e)}worldKnown(t){t||this.cache.clear();const e=this.world.limits.idleTimeoutMs||Rc*3;this.heardAt=performance.now(),this.heartbeat=setInterval(()=>this.beat(),Math.min(Rc,e/3)),this.sendRequests()}beat(){const t=performance.now()-this.heardAt;if(t>cp){this.drop(new Wt("timed_out",`the server said nothing for ${Math.round(t/1e3)} s`));return}this.ping().catch(()=>{})}handleChunk(t,e){const{id:n,key:s,revision:r,hash:a,payload:o}=t;this.stats.chunkBytes+=e;const l={key:s,revision:r,hash:a,payload:o,material:Tr(o)};this.debts.set(l,{connection:this.connection,bytes:e});let c=!1;if(n!==0){const h=this.requests.find(n);if(h?.kind!=="chunk"||!cf(h.key,s))throw Bt(`chunk ${Tn(s)} as the answer to request ${n}, which did not ask for it`);this.requests.take(n),this.backoff.reset(),c=!0,h.resolve(l),this.sendRequests()}else this.tracker.shape?.covers(s)&&(this.backoff.reset(),l.material===null&&this.cache.put(Tn(s),t),c=this.deliver(l));(!c||!this.options.manualCredit)&&this.taken(l)}taken(t){const e=this.debts.get(t);e!==void 0&&(this.debts.delete(t),!(e.connection!==this.connection||!this.connected)&&(this.takenBytes+=e.bytes,!(2*(this.takenBytes-this.creditedBytes)<this.world.limits.windowBytes)&&(this.creditedBytes=this.takenBytes,this.send(np(this.takenBytes)))))}handleUnchanged({id:t,key:e,revision:n,hash:s}){if(t!==0)throw Bt(`Unchanged as the answer to request ${t}, which knew of no chunk`);if(!this.tracker.shape?.covers(e)||(this.backoff.reset(),++this.stats.unchangedChunks,this.tracker.hashOf(e)===s))return;const r=this.cache.find(Tn(e));r?.hash!==s?this.refetch(e):this.deliver({key:e,revision:n,hash:s,payload:r.payload.slice(),material:null})}handleUniformColumn({x:t,z:e,lod:n,revision:s,runs:r}){for(const a of r){const o=this.uniformPayload(a.material),l=this.tracker.shape;if(l===null)return;const c=l.rows(n,t,e),h=Math.min(c.last,a.lastY);for(let u=Math.max(c.first,a.firstY);u<=h;++u)if(this.backoff.reset(),this.deliver({key:{lod:n,x:t,y:u,z:e},revision:s,hash:null,payload:o.slice(),material:a.material}),!this.connected)return}}uniformPayload(t){let e=this.uniform.get(t);if(e===void 0){if(!this.world.materials.some(({id:n})=>n===t))throw Bt(`a UniformColumn of material ${t}, which is not in Welcome`);e=vu(t),this.uniform.set(t,e)}return e}handleViewComplete({number:t}){if(!(t!==this.viewNumber||this.viewToSend||this.tracker.view===null)){this.completeToTell=!0;for(const e of this.tracker.missing())this.refetch(e);this.tellCompleteIfWhole()}}tellCompleteIfWhole(){!this.completeToTell||this.refetching.size>0||!this.connected||(this.completeToTell=!1,this.tellComplete())}handleHeights({id:t,heightsFx:e,looks:n,values:s}){const r=this.requests.find(t),a=e.length;if(r?.kind!=="places"||r.columns.length!==a)throw Bt(`${a} heights as the answer to request ${t}, which did not ask for them`);if(n.length!==(r.looks?a:0)||s.length!==a*r.fields.length)throw Bt(`${n.length} looks and ${s.length} values of ${a} columns for request ${t}`);if(n.some(o=>o>=this.world.looks.length))throw Bt("a look that is not in Welcome");this.requests.take(t),this.backoff.reset(),r.resolve({heightsFx:e,looks:r.looks?n:null,values:r.fields.length>0?s:null}),this.sendRequests()}handlePong({nonce:t}){const e=this.pings.get(t);if(e===void 0)throw Bt("a Pong that no Ping asked for");this.pings.delete(t),this.stats.latencyMs=performance.now()-e.sent,e.resolve(this.stats.latencyMs)}handleGoAway({reason:t,retryAfterMs:e}){this.leaving=new Wt("disconnected",`the server goes away: ${t}`,e)}handleFatal(t){this.leaving=Cc(t),this.drop(this.leaving)}handleError(t){const e=Cc(t),n=t.code==="overloaded"&&t.retryAfterMs>0;switch(n&&this.pace.refused(t.retryAfterMs,performance.now()),t.about){case"request":if(this.requests.find(t.requestId)===void 0)throw Bt(`an Error about request ${t.requestId}, which is not in flight`);t.code==="overloaded"&&(n||this.leaving!==null)?this.requests.putBack(t.requestId):this.requests.take(t.requestId).reject(e),this.sendRequests();return;case"view":if(t.viewNumber!==this.viewNumber)return;n?this.viewToSend=!0:this.emit("error",e),this.sendRequests();return;case"view_chunk":t.chunk!==null&&this.tracker.shape?.covers(t.chunk)&&this.refetch(t.chunk);return;case"ping":{const[s]=this.pings.entries();if(s===void 0)return;this.pings.delete(s[0]),s[1].reject(e);return}case"connection":this.leaving=e;return;default:this.emit("error",e)}}viewApplied(){this.completeToTell=!1,this.viewToSend=!0,this.viewNumber=this.viewNumber%4294967295+1,this.sendRequests()}sendView(){const{view:t}=this.tracker;if(this.viewToSend=!1,t===null){const s={centre:{x:up,y:0,z:0},horizontalRadius:0,verticalRadius:0};this.send(bc(s,this.viewNumber,[]));return}const e=(this.world.limits.frameBytes-2*Ec)/wu,n=[];for(const[,{key:s,hash:r}]of this.cache.entries()){if(n.length>=Math.min(e,hp))break;this.tracker.shape.covers(s)&&n.push({key:s,hash:r})}this.send(bc(t,this.viewNumber,n))}getChunk(t){return new Promise((e,n)=>{mu(t),this.ask({kind:"chunk",key:{...t},resolve:e,reject:n})})}getPlaces(t,e={}){return new Promise((n,s)=>{for(const{x:o,z:l}of t)if(!(Number.isSafeInteger(o)&&Number.isSafeInteger(l)))throw new Wt("out_of_range",`column ${o}, ${l}: its coordinates must be whole numbers`);const{looks:r=!1,fields:a=[]}=e;this.ask({kind:"places",columns:[...t],looks:r,fields:[...a],resolve:n,reject:s})})}ask(t){if(this.isClosed)throw this.closedError();this.requests.add(t),this.connected&&this.sendLater(0)}refetch(t){const e=Tn(t);this.refetching.has(e)||(this.refetching.add(e),this.getChunk(t).then(n=>{this.refetching.delete(e),(!this.deliver(n)||!this.options.manualCredit)&&this.taken(n),this.tellCompleteIfWhole()},n=>{this.refetching.delete(e),!this.isClosed&&(this.tracker.shape?.covers(t)&&this.emit("error",n),this.tellCompleteIfWhole())}))}sendLater(t){if(this.sendTimer!==void 0){if(t>0)return;clearTimeout(this.sendTimer)}this.sendTimer=setTimeout(()=>{this.sendTimer=void 0,this.sendRequests()},t)}sendRequests(){if(!this.connected||this.leaving!==null)return;const{limits:t}=this.world,e=t.frameBytes-2*Ec;let n=[];const s=()=>{n.length>0&&this.send(tp(n)),n=[]};for(;;){const r=this.pace.wait(performance.now()),o=this.requests.peek()!==void 0&&this.requests.inFlightCount<t.requestsInFlight;if(!this.viewToSend&&!o)break;if(r>0){this.sendLater(r);break}if(this.pace.take(),this.viewToSend){this.sendView();continue}const{id:l,request:c}=this.requests.next();if(c.kind==="chunk"){n.push({id:l,key:c.key,known:null}),yu*(n.length+1)>e&&s();continue}s();const h=Math.min(t.heightsPerRequest,Math.floor(e/Eu)),u=c.fields.map(d=>this.world.fields.indexOf(d));if(c.columns.length>h){const d=c.columns.length;this.requests.take(l).reject(new Wt("out_of_range",`${d} columns; this server takes ${h}`))}else if(u.includes(-1)){const d=c.fields[u.indexOf(-1)],f=this.world.fields.join(", ");this.requests.take(l).reject(new Wt("out_of_range",`no field ${d} here; there are: ${f}`))}else this.send(ep(l,c.columns,c.looks,u))}s()}ping(){return new Promise((t,e)=>{if(!this.connected)throw new Wt("disconnected","ping: the client is not connected");this.pace.take(),this.pings.set(BigInt(++this.lastNonce),{sent:performance.now(),resolve:t,reject:e}),this.send(ip(this.lastNonce))})}}function Cc({code:i,text:t,retryAfterMs:e}){const n=`the server says: ${t}`;switch(i){case"version":case"unauthorized":case"forbidden":return new Wt("refused",n);case"malformed":case"unexpected":return new Wt("broken_protocol",n);case"too_large":case"too_many_requests":case"out_of_range":return new Wt("out_of_range",n);case"overloaded":return new Wt("overloaded",n,e);case"cancelled":return new Wt("cancelled",n);case"timeout":return new Wt("timed_out",n);default:return new Wt("server_failed",n,e)}}const fp=1;function pp(i,t){const e=t??globalThis.WebSocket;if(e===void 0)throw new Wt("unreachable","there is no WebSocket here: pass one as the option WebSocket, or connect by tcp:// with talus-client/node");return n=>{const s=new e(i);s.binaryType="arraybuffer";let r=!1;const a=o=>{s.onopen=s.onmessage=s.onclose=null,s.onerror=()=>{},n.ended(o)};return s.onopen=()=>{r=!0,n.opened()},s.onmessage=({data:o})=>{if(o instanceof ArrayBuffer){n.received(new Uint8Array(o));return}a(new Wt("broken_protocol","the server sent text, where the protocol has bytes only")),s.close()},s.onerror=()=>{},s.onclose=({code:o,reason:l})=>{const c=l===""?`code ${o}`:`${l} (code ${o})`;a(r?new Wt("disconnected",`the connection to ${i} ended: ${c}`):new Wt("unreachable",`nobody answers at ${i}`))},{send:o=>{s.readyState===fp&&s.send(o)},close:()=>{s.onopen=s.onmessage=s.onclose=null,s.onerror=()=>{},s.close()}}}}const mp={empty:"has no bytes; it needs at least a version and an encoding",unknown_version:"begins with a byte that is no version known here, 3 or 4",unknown_encoding:"has a second byte that names no encoding of its version",truncated:"ends before the chunk does; it must be passed whole",too_long:"goes on after the chunk's end; it must be passed without other bytes",bad_materials:"has a list of materials that is empty, too long or out of order",bad_number:"holds a number that is past its range or not in its shortest form",bad_ending:"does not end as its chunk does; it was changed on its way",bad_hash:"decodes to voxels that do not have the hash it came with"};class zt extends Wt{constructor(t){super("bad_chunk",`the chunk payload ${mp[t]}`),this.fault=t}}const gp=[23,41,65,96,118,143,167,193,209,227,243,246,250,253,252,253],_p=[250,253,253,252,254,254,255,255,254,255,255,255,255,255,255,255],vp=[1,10,11,26,44,55,75,121,145,171,194,228,235,245,253,255],xp=[`41 52 53 40 54 68 55 40 53 54 47 40 40 40 40 40
46 42 50 64 56 71 79 64 69 88 66 64 64 64 64 64
-7 13 26 0 -24 5 0 0 8 6 -11 0 0 0 0 0
-47 -60 -37 0 -54 -35 9 0 -9 6 35 0 0 0 0 0
-1 -7 -27 0 -12 9 -7 0 -19 -10 0 0 0 0 0 0
16 -16 -28 0 42 -1 -36 0 28 22 -10 0 0 0 0 0
7 -16 -9 0 15 0 13 0 -2 -17 12 0 0 0 0 0
-41 -43 -24 0 -14 0 8 0 1 34 19 0 0 0 0 0
-20 -4 -2 0 4 3 4 0 -4 -3 -18 0 0 0 0 0
-54 -17 -23 0 -14 0 16 0 5 5 45 0 0 0 0 0
11 -16 -22 0 -3 1 -1 0 -16 -5 -2 0 0 0 0 0
-51 -19 33 0 -47 -6 26 0 -30 -11 -2 0 0 0 0 0
11 8 31 0 -2 -2 -12 0 -5 0 -8 0 0 0 0 0
79 116 107 0 21 27 25 0 12 -13 -28 0 0 0 0 0
19 -3 -1 0 -7 1 2 0 -6 2 -4 0 0 0 0 0
101 112 74 0 4 0 -13 0 -12 0 15 0 0 0 0 0
-10 2 15 0 1 2 -14 0 -14 0 8 0 0 0 0 0
114 100 45 0 -51 2 127 0 -29 0 16 0 0 0 0 0`,`41 53 52 40 52 68 53 40 54 55 45 40 40 40 40 40
30 49 71 64 38 69 86 64 57 78 83 64 64 64 64 64
3 17 32 0 -28 5 7 0 2 4 -7 0 0 0 0 0
-79 -81 -37 0 -42 -36 1 0 17 19 46 0 0 0 0 0
-1 -10 -32 0 -15 11 -11 0 -21 -11 3 0 0 0 0 0
36 -24 -65 0 42 -3 -44 0 66 37 -18 0 0 0 0 0
11 -9 -4 0 14 -2 13 0 0 -11 13 0 0 0 0 0
-1 -15 -11 0 8 1 -3 0 -1 14 -3 0 0 0 0 0
-5 -3 7 0 7 -4 7 0 4 -3 -5 0 0 0 0 0
-6 -7 -31 0 8 0 -10 0 15 2 4 0 0 0 0 0
13 -16 -26 0 3 -1 -2 0 -11 -4 -2 0 0 0 0 0
-94 -14 52 0 -60 5 48 0 -43 -12 2 0 0 0 0 0
7 -2 27 0 -1 -1 -19 0 -1 3 -6 0 0 0 0 0
41 71 111 0 9 36 72 0 -19 -29 -28 0 0 0 0 0
20 -2 -3 0 -16 4 -3 0 -11 4 -9 0 0 0 0 0
87 75 53 0 1 -1 -7 0 -36 1 37 0 0 0 0 0
-14 4 29 0 8 2 -15 0 -6 0 5 0 0 0 0 0
92 76 28 0 -47 -1 127 0 -25 1 4 0 0 0 0 0
-3 12 -1 0 -41 -36 15 0 17 -34 -46 0 -2 -30 7 0
24 -3 -37 0 56 69 32 0 -31 -65 -91 0 -62 -4 64 0
-1 11 -5 0 15 -34 -39 0 -33 -30 18 0 18 -26 5 0
-38 -4 31 0 23 63 55 0 -82 -64 -24 0 62 -11 -61 0
0 1 1 0 -7 6 4 0 22 7 0 0 27 -12 -19 0
94 -10 4 0 29 -9 32 0 41 -29 -29 0 40 -16 5 0
0 -1 0 0 -8 3 3 0 23 0 -3 0 28 -17 -22 0
87 0 0 0 28 7 31 0 34 -18 -37 0 44 2 -7 0`,`52 44 49 40 50 53 52 40 50 45 53 40 40 40 40 40
50 54 71 64 52 64 75 64 50 74 77 64 64 64 64 64
17 22 17 0 -5 -4 -1 0 -3 -2 -2 0 0 0 0 0
-27 -22 -26 0 -1 -11 -6 0 14 3 4 0 0 0 0 0
-1 -5 -23 0 -13 11 -12 0 -21 -2 5 0 0 0 0 0
16 -19 -24 0 51 1 -45 0 28 18 -15 0 0 0 0 0
0 -1 0 0 -4 5 -3 0 -3 -4 0 0 0 0 0 0
25 23 30 0 -7 1 6 0 -7 -21 -24 0 0 0 0 0
-1 -2 2 0 1 2 2 0 0 -2 -3 0 0 0 0 0
-27 -4 -5 0 -13 0 11 0 2 8 24 0 0 0 0 0
11 -32 -29 0 -1 2 0 0 -15 -1 0 0 0 0 0 0
-18 21 31 0 -32 2 20 0 -32 -8 1 0 0 0 0 0
4 -5 6 0 3 -1 -6 0 2 0 -1 0 0 0 0 0
-2 40 89 0 12 0 5 0 19 -5 -27 0 0 0 0 0
-4 -3 9 0 4 -1 -1 0 1 0 -2 0 0 0 0 0
19 -2 1 0 5 2 -5 0 -5 -1 6 0 0 0 0 0
3 -1 -2 0 -1 1 -2 0 1 0 -1 0 0 0 0 0
23 -1 -20 0 -20 4 21 0 -10 1 4 0 0 0 0 0`,`51 49 53 40 49 53 51 40 49 51 53 40 40 40 40 40
54 65 62 64 53 66 71 64 63 69 71 64 64 64 64 64
13 20 13 0 -4 -4 0 0 -2 -1 -1 0 0 0 0 0
4 -20 -35 0 -10 -7 -3 0 8 3 9 0 0 0 0 0
-2 -4 -23 0 -13 11 -12 0 -19 -2 2 0 0 0 0 0
16 -22 -17 0 39 1 -34 0 17 22 -14 0 0 0 0 0
0 -2 1 0 1 4 1 0 -1 -4 -1 0 0 0 0 0
20 18 18 0 7 -1 -3 0 -11 -18 -18 0 0 0 0 0
0 -2 4 0 1 -1 3 0 0 -3 0 0 0 0 0 0
-32 -9 -6 0 -15 0 11 0 3 10 30 0 0 0 0 0
11 -29 -27 0 -6 2 2 0 -19 -1 0 0 0 0 0 0
-18 20 25 0 -28 5 19 0 -25 -5 1 0 0 0 0 0
5 -3 8 0 1 -1 -8 0 1 1 -1 0 0 0 0 0
2 27 77 0 12 -5 4 0 16 -3 -26 0 0 0 0 0
-4 -1 6 0 1 0 -1 0 1 1 -4 0 0 0 0 0
6 2 8 0 5 3 -6 0 -3 -1 4 0 0 0 0 0
3 -2 -1 0 -2 1 -1 0 0 0 -1 0 0 0 0 0
14 0 -15 0 -16 1 30 0 -3 0 -1 0 0 0 0 0
3 5 4 0 9 -9 -13 0 -14 -9 8 0 -7 -15 -5 0
-1 0 3 0 -19 -25 -17 0 20 24 19 0 3 -2 -1 0
3 2 4 0 -3 -6 -6 0 -6 -7 -4 0 1 -5 -3 0
4 0 -5 0 -10 -14 -18 0 16 16 12 0 -12 4 7 0
-1 -2 0 0 -15 8 1 0 -6 5 0 0 -2 4 0 0
8 -1 -1 0 2 0 -8 0 -20 0 8 0 -40 12 4 0
0 -2 0 0 -11 5 0 0 1 0 0 0 4 5 -4 0
-3 0 1 0 21 8 -7 0 0 -2 4 0 13 -22 4 0`,`40 40 40 40 40 61 40 40 40 40 40 40 40 40 40 40
64 64 64 64 64 66 64 64 64 64 64 64 64 64 64 64
0 4 0 0 0 0 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
0 0 -19 0 -28 5 -30 0 -26 -1 -3 0 0 0 0 0
18 -20 -38 0 42 1 -43 0 23 26 -30 0 0 0 0 0
0 0 0 0 0 2 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 2 0 0 0 0 0 0 0 0 0
0 0 0 0 -15 1 16 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
5 -2 4 0 0 0 0 0 0 0 0 0 0 0 0 0
23 0 -24 0 0 0 0 0 0 0 0 0 0 0 0 0
-2 1 -4 0 0 0 0 0 0 0 0 0 0 0 0 0
9 -1 -6 0 0 0 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0`,`40 40 40 40 40 63 40 40 40 40 40 40 40 40 40 40
64 64 64 64 64 64 64 64 64 64 64 64 64 64 64 64
0 5 0 0 0 0 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
-10 1 -25 0 -33 7 -33 0 -32 5 -15 0 0 0 0 0
27 -23 -33 0 43 0 -40 0 20 23 -23 0 0 0 0 0
0 0 0 0 0 3 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
0 0 0 0 3 -1 3 0 0 0 0 0 0 0 0 0
0 0 0 0 -17 0 19 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
4 -2 3 0 0 0 0 0 0 0 0 0 0 0 0 0
23 0 -22 0 0 0 0 0 0 0 0 0 0 0 0 0
-4 1 -5 0 0 0 0 0 0 0 0 0 0 0 0 0
7 0 -10 0 0 0 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
6 4 8 0 -16 -19 -40 0 -30 -22 -5 0 -23 -20 -25 0
12 1 -2 0 -17 -3 -24 0 9 -1 -4 0 -2 -3 -11 0
11 4 17 0 -6 -10 -1 0 -30 -14 -14 0 -21 -37 -22 0
-5 0 -11 0 -6 15 -10 0 26 -12 13 0 52 -1 -45 0
-2 0 0 0 5 0 0 0 6 0 0 0 6 0 0 0
0 0 0 0 -2 0 0 0 2 0 0 0 0 0 0 0
0 0 0 0 -1 0 0 0 0 0 0 0 -5 0 0 0
0 0 0 0 1 0 0 0 0 0 0 0 0 0 0 0`],Sp=0,Mp=1,yp=2,pa=0,ma=2,wp=4,Ep=6,bp=8,Tp=10,Ap=12,Rp=14,Lc=16,Pc=18,as=20,Cp=22,lo=24,co=26,ho=28,Ic=[[Ap,bp],[Lc,Pc],[pa,ma],[Tp,Rp],[wp,Ep],[Cp,Pc],[pa,as],[ma,as],[Lc,as],[pa,lo],[ma,co],[as,lo],[as,co]],Lp=9;function Pp(){return xp.map(i=>Int8Array.from(i.trim().split(/\s+/),Number))}const uo=13;class Dc{keys=new Int32Array(1<<uo).fill(-1);ends=new Int32Array(1<<uo);weights;pairs;constructor(t){this.weights=Pp().filter((e,n)=>n%2===1===t),this.pairs=t?Ic.length:Lp}fill=(t,e)=>{const n=this.weights[t>>>ho];let s=0,r=0;for(let u=0;u<this.pairs;++u){const[d,f]=Ic[u],_=u*32+(t>>>d&3)+4*(t>>>f&3);s=Math.max(-128,Math.min(127,s+n[_])),r=Math.max(-128,Math.min(127,r+n[_+16]))}const a=Math.max(s,0)>>3,o=gp[a],l=_p[a],c=o+1+((l-o-2)*vp[Math.max(r,0)>>3]>>8),h=o|c<<8|l<<16;return this.keys[e]=t,this.ends[e]=h,h}}function Nc(i){return Math.imul(i,-1640531535)>>>32-uo}const pe=16,ga=256,Ip=2*pe,pl=65538,Dp=4096;class Np{bytes=new Uint8Array(pl+Dp);states=new Int32Array(pe);next=0;end=0;begin(t){this.bytes.set(t),this.next=2,this.end=t.length}left(){return this.end-this.next}number(){let t=0;for(let e=0;e<=14;e+=7){if(this.next>=this.end)throw new zt("truncated");const n=this.bytes[this.next++];if(t|=(n&127)<<e,!(n>=128)){if(n===0&&e>0||t>65535)break;return t}}throw new zt("bad_number")}materials(t){const e=this.number();if(e===0||e>t)throw new zt("bad_materials");const n=[];for(let s=0;s<e;++s)n.push(this.number());return n}takeStates(){if(this.left()<Ip)throw new zt("truncated");for(let t=0;t<pe;++t){const e=this.bytes[this.next]|this.bytes[this.next+1]<<8;if(e<ga)throw new zt("bad_ending");this.states[t]=e,this.next+=2}}read(t,e){let n=this.states[e];const s=t[n&255];return n=(s>>>16)*(n>>8)+(n&255)-(s>>8&255),n<ga&&(n=n<<8|this.bytes[this.next++]),this.states[e]=n,s&255}checkRead(){if(this.next>this.end)throw new zt("truncated")}checkAllRead(){if(this.next!==this.end)throw new zt("too_long")}checkFinalStates(){for(let t=0;t<pe;++t)if(this.states[t]!==ga)throw new zt("bad_ending")}}function ml(i,t){let e=0;for(let n=0;n<t.length;++n){const s=t[n];if(e+s>256)throw new zt("bad_number");i.fill(n|e<<8|s<<16,e,e+s),e+=s}if(e!==256)throw new zt("bad_number")}const ve=32,He=ve*ve,gi=64,_i=1,Uc=341;function vi(i){return(i>>31|0-i>>>31)+1}function Fc(i,t){return 3-((t-(i&255)>>>31)+(t-(i>>8&255)>>>31)+(t-(i>>16)>>>31))}class Up{even=new Dc(!1);odd=new Dc(!0);planes=new Uint8Array(He*gi+ve);keys=new Int32Array(ve);symbols=new Int32Array(ve+1);firstOfHeight=new Int32Array(ve+1);runs=new Int32Array(He*gi);nextRun=new Int32Array(He*gi);ids=[];decode(t){const e=t.next,n=t.number(),s=n>gi+1&&n<=gi+pe;let r=[];if(!s&&(t.next=e,r=t.materials(gi),Oc(r),r.length===1))return t.checkAllRead(),r[0];const a=(s?n-gi:r.length)-1;t.takeStates();for(let o=1;o<=a;++o)this.readPlane(t,o*He);return t.checkAllRead(),s?(r=Op(t,a+1),Oc(r)):t.checkFinalStates(),this.ids=r,null}readPlane(t,e){const n=Fp(t);this.prepareFirstRow(e-He);for(let s=0;s<ve;++s){this.readEvenSymbols(t),this.readOddSymbols(t);const r=s+1<ve&&n>>>s+1&1?Mp:Sp,a=this.readRow(t,e,s,s>0&&(n>>>s&1)===0,r<<ho);if(t.checkRead(),a)throw new zt("bad_number")}}prepareFirstRow(t){const{planes:e,keys:n}=this,s=a=>e[t+(a<ve?a:ve-1)];let r=_i;for(let a=0;a<ve;++a){const o=s(a),l=r;r=vi(s(a+1)-o),n[a]=l|r<<2|vi(s(a+2)-o)<<4|Uc<<6|_i<<16|yp<<ho}}readEvenSymbols(t){const{keys:e,symbols:n}=this,{fill:s,keys:r,ends:a}=this.even,{bytes:o,states:l}=t;let c=t.next;for(let h=0;h<pe;++h){const u=e[2*h],d=Nc(u),f=r[d]===u?a[d]:s(u,d);let _=l[h];const S=_&255,p=Fc(f,S),m=p<<3,y=f<<8>>>m&255;_=((f>>>m)-y&255)*(_>>8)+S-y;const M=_-256>>>31;l[h]=_<<(M<<3)|o[c]&-M,c+=M,n[2*h]=p}t.next=c}readOddSymbols(t){const{keys:e,symbols:n}=this,{fill:s,keys:r,ends:a}=this.odd,{bytes:o,states:l}=t;let c=t.next,h=n[0];for(let u=0;u<pe;++u){const d=n[2*u+2],f=e[2*u+1]|h<<lo|d<<co;h=d;const _=Nc(f),S=r[_]===f?a[_]:s(f,_);let p=l[u];const m=p&255,y=Fc(S,m),T=y<<3,M=S<<8>>>T&255;p=((S>>>T)-M&255)*(p>>8)+m-M;const E=p-256>>>31;l[u]=p<<(E<<3)|o[c]&-E,c+=E,n[2*u+1]=y}t.next=c}readRow(t,e,n,s,r){const{planes:a,keys:o,symbols:l}=this,{bytes:c}=t,h=e+n*ve,u=h-He,d=n===0?u:h-ve,f=n===0?u:u-ve;let _=t.next;const S=s?0:-1;let p=0,m=0,y=0,T=0,M=0,A=_i<<2,E=Uc,g=0,w=0;for(let C=0;C<ve;++C){const D=l[C];let B=(D&1)-(D>>1);D===3&&(B=c[_++]<<24>>24),m=B+(m&S);const V=a[u+C],L=a[d+C],H=L-V;y=V+(H&~(H>>31)&a[f+C]-L>>31)+m;const $=y-V;p|=$|ve-y,a[h+C]=y;const G=2+($-2&$-2>>31);C===0&&(T=M=y,g=G),E=(E<<2|vi(m))&1023;const tt=vi(y-T);C>1&&(o[C-2]=A|vi(y-M)<<4|E<<6|(w&12)<<14|g<<18|r),A=A>>2|tt<<2,g=(g<<2|G)&63,w=w<<2|vi(a[u+ve+C]-V),M=T,T=y}const N=g&3;return E=(E<<2|_i)&1023,o[ve-2]=A|vi(T-M)<<4|E<<6|(w&12)<<14|g<<18|r,A=A>>2|_i<<2,g=(g<<2|N)&63,E=(E<<2|_i)&1023,o[ve-1]=A|_i<<4|E<<6|(w&3)<<16|g<<18|r,t.next=_,p<0}expand(t){const{ids:e,planes:n,firstOfHeight:s,nextRun:r,runs:a}=this;s.fill(-1);let o=0;for(let l=e.length-1;l>0;--l){const c=(l+1)*He;for(let h=l*He;h<c;){const u=h,d=n[h];do++h;while(h<c&&n[h]===d);a[o]=u&He-1|h-u-1<<10|l<<20,r[o]=s[d],s[d]=o++}}t.fill(e[0],0,He);for(let l=0;l<ve;++l){const c=l*He;l>0&&t.copyWithin(c,c-He,c);for(let h=s[l];h>=0;h=r[h]){const u=a[h],d=e[u>>20],f=c+(u&He-1),_=(u>>10&He-1)+1;if(_>64)t.fill(d,f,f+_);else for(let S=f;S<f+_;++S)t[S]=d}}}}function Fp(i){const{bytes:t}=i,e=t[i.next++];let n=0;for(let s=0;s<4;++s)e>>s&1&&(n|=t[i.next++]<<8*s);if(i.checkRead(),e>15||(n&1)!==0)throw new zt("bad_number");return n}function Oc(i){for(let t=1;t<i.length;++t)if(i[t]===i[t-1])throw new zt("bad_materials")}function Op(i,t){const e=new Uint8Array(pe);for(let r=0;r<pe;++r){const a=i.states[r]-256;if(a>255)throw new zt("bad_ending");e[r]=a}const n=[];let s=0;for(let r=0;r<t;++r){let a=0;for(let o=0;;o+=7){if(s===pe||o>14)throw new zt("bad_ending");const l=e[s++];if(a|=(l&127)<<o,!(l>=128)){if(l===0&&o>0||a>65535)throw new zt("bad_ending");break}}n.push(a)}for(;s<pe;++s)if(e[s]!==0)throw new zt("bad_ending");return n}const ii=32,Ei=4,Jn=ii/Ei,kp=256,kc=271;class Bp{constructor(t,e){this.source=t,this.fast=new Uint16Array(e).fill(32768),this.slow=new Uint16Array(e).fill(32768),this.age=new Uint8Array(e);let n=0;for(let s=0;s<4;++s){const r=this.byte();r===255&&++n,this.code=this.code*256+r>>>0}this.allOnes=n===4}fast;slow;age;range=4294967295;code=0;past=0;allOnes;byte(){if(this.source.next<this.source.end)return this.source.bytes[this.source.next++];if(++this.past>2)throw new zt("truncated");return 0}read(t){const e=this.fast[t],n=this.slow[t],s=this.age[t],r=(this.range>>>12)*(e+n>>5),a=this.code<r?0:1,o=32-Math.clz32(s+1),l=Math.min(o,4);for(s<31&&(this.age[t]=s+1),a?(this.range-=r,this.code-=r,this.fast[t]=e-(e>>l),this.slow[t]=n-(n>>o)):(this.range=r,this.fast[t]=e+(65536-e>>l),this.slow[t]=n+(65536-n>>o));this.range<16777216;)this.range*=256,this.code=this.code*256+this.byte();return a}checkEnd(){if(this.past!==2)throw new zt("too_long");if(this.code>65535||this.allOnes)throw new zt("bad_ending")}}function zp(i,t){const e=i.materials(kp);for(let h=1;h<e.length;++h)if(e[h]<=e[h-1])throw new zt("bad_materials");const n=new Bp(i,8+2*kc),s=new Uint8Array(ii*ii*ii),r=new Uint8Array(Jn*Jn*Jn),a=(h,u,d)=>h<0||u<0||d<0?0:s[(u*ii+d)*ii+h],o=(h,u,d,f)=>{const _=a(u,d-1,f),S=a(u-1,d,f),p=a(u,d,f-1),y=h+(_===S?S===p?0:1:_===p?2:S===p?3:4)*3;if(n.read(y)===0)return _;if(S!==_&&n.read(y+1)===0)return S;if(p!==_&&p!==S&&n.read(y+2)===0)return p;let T=1;for(let M=0;M<8;++M)T=T*2+n.read(h+15+T);return T-256},l=8,c=8+kc;for(let h=0;h<r.length;++h){const u=h%Jn,d=(h>>3)%Jn,f=h>>6,_=(u>0?r[h-1]:0)+2*(d>0?r[h-Jn]:0)+4*(f>0?r[h-Jn*Jn]:0);r[h]=n.read(_);const[S,p,m]=[u*Ei,f*Ei,d*Ei],y=r[h]?0:o(l,S,p,m);for(let T=p;T<p+Ei;++T)for(let M=m;M<m+Ei;++M)for(let A=S;A<S+Ei;++A)s[(T*ii+M)*ii+A]=r[h]?o(c,A,T,M):y}n.checkEnd();for(let h=0;h<s.length;++h){const u=s[h];if(u>=e.length)throw new zt("bad_number");t[h]=e[u]}}function Au(i,t,e,n){for(let a=0;a<e;++a)n[a]=i.read(t,a);let s=0,r=0;for(let a=0;a<e;++a){const o=n[a];if(o<2)continue;for(;s<o-1;)r|=i.bytes[i.next++]<<s,s+=8;const l=1<<o-1;n[a]=l|r&l-1,r>>>=o-1,s-=o-1}}const Bc=256;class Ru{ids=new Uint16Array(Bc);slots=new Int32Array(256);take(t){const e=t.materials(Bc);for(let s=1;s<e.length;++s)if(e[s]===e[0]||s>1&&e[s]<=e[s-1])throw new zt("bad_materials");if(t.left()<e.length)throw new zt("truncated");const n=e.map((s,r)=>t.bytes[t.next+r]+1);ml(this.slots,n),this.ids.set(e),t.next+=e.length}read(t,e){return this.ids[t.read(this.slots,e)]}}const Ws=32768,_a=16;class Gp{materials=new Ru;digits=new Int32Array(256);lengths=new Int32Array(pe);decode(t,e){this.materials.take(t);const n=t.number(),s=n===Ws;if(!s){if(t.left()<_a)throw new zt("truncated");ml(this.digits,t.bytes.subarray(t.next,t.next+_a)),t.next+=_a}t.takeStates(),s?this.readSingle(t,e):this.readRuns(t,n,e),t.checkAllRead(),t.checkFinalStates()}readSingle(t,e){for(let n=0;n<Ws;++n)e[n]=this.materials.read(t,n%pe),n%256===255&&t.checkRead()}readRuns(t,e,n){let s=0;for(let r=e;r>0;r-=pe){const a=Math.min(r,pe);Au(t,this.digits,a,this.lengths);let o=!1;for(let l=0;l<a;++l){const c=this.materials.read(t,l),h=s+this.lengths[l]+1;o||=h>Ws,!o&&(h===s+1?n[s]=c:n.fill(c,s,h),s=h)}if(t.checkRead(),o)throw new zt("bad_number")}if(s!==Ws)throw new zt("bad_number")}}const Hp=[60,10,11,12,17,12,13,17,22,24,20,15,11,6,4,2],Vp=`
53 85 199 28 163 242 50 180 206 83 153 208 43 218 236 91 198 217 110 180 237 122 229 245
134 210 236 151 250 253 151 173 218 21 46 248 8 20 28 15 28 42 18 254 255 44 85 240
53 95 131 22 71 83 49 252 253 59 241 245 21 254 255 162 203 234 100 123 252 81 237 247
35 251 252 62 135 230 122 141 251 115 135 252 59 246 252 199 211 231 8 251 253 105 140 250
69 251 255 116 249 252 166 220 221 75 254 255 130 178 201 146 233 239 164 223 244 158 240 249
189 234 238 183 236 248 188 209 247 189 252 253 200 235 247 209 247 250 206 253 254 216 235 245
223 253 254 222 245 246 229 249 252 232 254 255 240 254 255 241 248 249 228 233 234 245 254 255
240 244 250 249 250 251 250 254 255 252 254 255 253 254 255 132 182 228
`,Wp=[`5555777d777ddfhk577d7bfebdbhfjjm57797dbh7bjefjjp7999bdhkb9hkenna
G3Aa377a3d7aaaaaHL5a2hSa4kIaaaaaD3aa3NdaGXXaaaaaCa2a3h9aHhZaaaaa
77ddd99hddhhhkkmddd9hhmm9hhhkqpq7999dhhhdhjkkpmq999hhhkm9hkmmqqa
lziabaaa59kaaaaazj9aaaaaaaaadaaaTiiaXaaa3kkaaaaaakhaaaaaaaaaXaaa
5337aaaaa3aaaaaa03FaaaaaaXaaaaaa3zPaaaaaa9aaaaaaPaadaaaaaaaaaaaa
332daaaaa3aaaaaaGz6aaaaaa9aaaaaaGa0aaaaaaXaaaaaaPaahaaaaaaaaaaaa`,`AzTcTiTlTiTlTuuuALTlTlsnLllrTusvLLliTllrTlsnTusvTcTlTisrTisrnrsa
T7zaTdLaolAaaaaaLf6agfaahraaaaaau7gau9gawlTaaaaaT98alhYamrYaaaaa
TusrTvsvsvsyvysysvsuuvrqnrvvuvvysvrrrrrrsuvruvvvuyvyuxvyuxvyrxva
5v7a2aaa6l5aaaaa1okaaaaaaaaa4aaa5ySa4aaa6r5aaaaa1ohaaaaaaaaaJaaa
PY0eaaaaaTaaaaaa38PaaaaaaLaaaaaa0gQaaaaaa9aaaaaaFaalaaaaaaaaaaaa
FnBnaaaaauaaaaaaPcPaaaaaaeaaaaaa0gRaaaaaa9aaaaaaBaaoaaaaaaaaaaaa`,`z6LzzcLcz8LeLlllz8TcLcsjziljiosrz8icziioLcsjiosrz7lfzdnnzdnmYnsa
073aAd8a8oNaaaaa1c3a6j5aSrJaaaaa0Nzag9fa8oNaaaaa2a5a2Y5a4sOaaaaa
TTssTusssrsvuvsvTusuuuvvlvswuvvvlrsqrrsruuvvuvvvTuvtguvxTuvxnwva
lTuadaaaLilaaaaactkaaaaaaaaadaaaouoa9aaacrnaaaaaiphaaaaaaaaa9aaa
P52baaaaazaaaaaa366aaaaaa7aaaaaa0gVaaaaaa9aaaaaaPaaiaaaaaaaaaaaa
Fe2jaaaaagaaaaaa0L6aaaaaabaaaaaa0gMaaaaaa9aaaaaaFaajaaaaaaaaaaaa`,`aaaYsorruorxywyyffejjkwmrrptytyxccsjeopwqjtoxqxxlkmhsmxmomtmytya
A3aaTzcaaiGaaaaa4TGa4nJa2r2aaaaar3lal5iaeehaaaaa4Laa5nbaNnIaaaaa
eonrotrtrtrtxyyyfootwyyxoxtxxyyyetotqxkyrvwyyxyyoxpkwwytrwxtyyya
GxaabaaaGuaaaaaazrhaaaaaaaaabaaaaylaJaaazteaaaaaarkaaaaaaaaa9aaa
GrGtaaaaaeaaaaaaGeGaaaaaaYaaaaaaGazaaaaaahaaaaaaFaamaaaaaaaaaaaa
0lataaaaafaaaaaaGlAaaaaaahaaaaaa3a3aaaaaabaaaaaaFaamaaaaaaaaaaaa`,`06gio9no7NeqTmvr3hgifSx99ohplpyy2Nbocobo7Sxkltvy34nf1Sjk2Sohehva
P66aPiXa4uXaaaaa4c4a1tEaOyZaaaaaP1zaP9fa4vcaaaaaG77a1kOaUvZaaaaa
znswywttrqsouwyviorowxyyqwqwyyyyeomqqyryuxyyyyyyiqwqoyyyowxqwwya
itmaoaaaftkaaaaaoymaaaaaaaaataaaujuakaaaghyaaaaafwmaaaaaaaaamaaa
548baaaaa1aaaaaaF2VaaaaaaWaaaaaaPdPaaaaaahaaaaaa7aaXaaaaaaaaaaaa
337maaaaa4aaaaaaGPiaaaaaaZaaaaaaPfVaaaaaa9aaaaaaPaahaaaaaaaaaaaa`,`eAslxhrwf9YnrkxrAfTuohxmeqeouwyy3Seulcmn7StmlqyyPSlm6NwqaNnqmkya
66caPdXaNu9aaaaaJiSa4mKaZxZaaaaa01gaPWfaeobaaaaa289a19Za5wXaaaaa
cjlmytqqrtrqwtxviotqtxyytxqvyyyyejqoouqwrtyyxyyyiwwwovyyotwtwxya
9rhaeaaadthaaaaaiykaaaaaaaaapaaaTllaZaaaghwaaaaa6qtaaaaaaaaa9aaa
33gjaaaaa4aaaaaa3LVaaaaaaZaaaaaa0cPaaaaaajaaaaaaPaa9aaaaaaaaaaaa
33btaaaaa1aaaaaa3VgaaaaaaZaaaaaaPcVaaaaaaXaaaaaaFaamaaaaaaaaaaaa`,`Tbseldnredqqtkwsidljo9xmldjmrpxw8dljfjnooXxmrpxweNodi9wpk9wpomya
5zLa7hhaJp7aaaaaOl6aOqZaKtZaaaaa57gacXoa7kdaaaaaOfTaNk9aOq9aaaaa
iorsrtwrrtwtxwywlowqxxyyoxtwyyyyeotooypyttyyxyyyokxmwtyxwqyxwwya
6jqaXaaacumaaaaafxhaaaaaaaaakaaaLtwaZaaaitqaaaaa8wpaaaaaaaaahaaa
0LgmaaaaaNaaaaaa3bVaaaaaa9aaaaaa0f6aaaaaamaaaaaaFaahaaaaaaaaaaaa
FfctaaaaaXaaaaaa0f6aaaaaa9aaaaaa3c6aaaaaa9aaaaaaFaamaaaaaaaaaaaa`,`PG38555t2N5rAlsrPdFi55sb4iOjAtsv2g2LJnJj25sbTwsy12P725bk245hYnsa
1APa1l1aUT3aaaaa4uUa1xUaUvIaaaaaPz0aPdca4T3aaaaa4lUa1tOaUrmaaaaa
eYefrosenosksysvfij7rxywoxkrxyyyejhojxrxsvywsyvyiktiopxwoTwtwxya
u5xauaaaixqaaaaajyhaaaaaaaaaraaaulyaraaagqyaaaaafymaaaaaaaaamaaa
b4bJaaaaaUaaaaaaP4caaaaaaIaaaaaaPePaaaaaamaaaaaa7aa7aaaaaaaaaaaa
54NNaaaaaNaaaaaa2PdaaaaaaZaaaaaaPfPaaaaaa9aaaaaa6aahaaaaaaaaaaaa`],va=1<<30;class Xp{gap=va;counts=new Int32Array(256);gaps=new Int32Array(pe);ids=new Int32Array(pe);materials;inGroup=0;taken=0;left=0;constructor(){ml(this.counts,Hp)}begin(t,e,n){this.materials=e,this.left=n,this.readGroup(t)}take(t){const e=this.ids[this.taken++];return this.taken<this.inGroup?this.gap=this.gaps[this.taken]:this.readGroup(t),e}checkAllTaken(){if(this.gap<va-32768)throw new zt("bad_number")}readGroup(t){const e=Math.min(this.left,pe);if(this.taken=0,this.inGroup=e,this.left-=e,this.gap=va,e!==0){Au(t,this.counts,e,this.gaps);for(let n=0;n<e;++n)this.ids[n]=this.materials.read(t,n);this.gap=this.gaps[0]}}}const zc=32;function qp(i,t,e,n,s,r,a,o){const l=a===zc-1?a:a+1,c=a===0?0:a-1,h=i[e+a],u=i[n+a],d=i[s+a],f=i[r+a],_=u===d?h:u,S=u===d?u:h;let p=0,m=-1,y=-1;for(let T=a&1?0:2;T<10;++T){let M;switch(T){case 0:case 1:{const A=i[t+a-1],E=a===zc-1?A:i[t+a+1];M=(_===E||_!==A&&S===E)===(T===0)?E:A;break}case 2:M=_;break;case 3:M=S;break;case 4:M=i[e+l];break;case 5:M=i[e+c];break;case 6:M=i[n+l];break;case 7:M=i[n+c];break;case 8:M=f;break;default:M=d}if(!(M===m||M===y)){if(p===o)return M;p===0?m=M:y=M,++p}}return-1}const $p=384;function Yp(i){return i<=57?i-48:i<=90?i-65+10:i-97+36}function Kp(){const i=Vp.trim().split(/\s+/).map(Number);return Wp.map(t=>{const e=t.replace(/\s/g,"");return Int32Array.from({length:$p},(n,s)=>{const r=3*Yp(e.charCodeAt(s));return i[r]|i[r+1]<<8|i[r+2]<<16})})}const kt=32,vn=kt*kt,Zp=94,Xs=1431655765,Jp=-1431655766,We=-1,xa=-1,un=16,Sa=un*(kt/2);class Qp{intervals=Kp();materials=new Ru;exceptions=new Xp;buffer=new ArrayBuffer((vn+1)*kt*2);voxels=new Uint16Array(this.buffer);pairs=new Uint32Array(this.buffer);rowMaterial=new Int32Array(vn+1);equalsWest=new Int32Array(vn+1);equalsNorth=new Int32Array(vn+1);equalsBelow=new Int32Array(vn+1);north=new Int32Array(un);below=new Int32Array(un);belowNorth=new Int32Array(un);belowSouth=new Int32Array(un);same=new Int32Array(un);upright=new Int32Array(un);level=new Int32Array(un);levelSouth=new Int32Array(un);full=new Int32Array(un);quiet=new Uint8Array(un);contexts=new Int32Array(Sa);places=new Int32Array(Sa);escapes=new Int32Array(Sa);coded=0;decode(t,e){this.materials.take(t);const n=t.number();if(t.left()<1+2*pe)throw new zt("truncated");const s=this.intervals[t.bytes[t.next++]];if(s===void 0)throw new zt("bad_number");t.takeStates(),this.begin(this.materials.ids[0]),this.exceptions.begin(t,this.materials,n);for(let r=0;r<Zp;++r){const a=Math.max(0,r-kt+2>>1),l=Math.min(kt-1,r>>1)-a+1,c=a*kt+r-2*a;this.coded=0;for(let h=0;h<l;++h)this.beginRow(t,h,c+30*h);this.readBatch(t,s),this.coded=0;for(let h=0;h<l;++h)this.finishRow(t,h,c+30*h);this.readBatch(t,s);for(let h=0;h<l;++h)this.compareRow(h,c+30*h)}this.exceptions.checkAllTaken(),t.checkAllRead(),t.checkFinalStates(),e.set(this.voxels.subarray(0,vn*kt))}begin(t){this.voxels.fill(t,vn*kt),this.rowMaterial[vn]=t,this.equalsWest[vn]=We}beginRow(t,e,n){const s=n&kt-1;let r=n-1,a=n-kt,o=a-1,l=a+1,c=We,h=We,u=We,d=We;n<kt?(s===0&&(r=vn),a=o=l=r):(s===0?r=o=a:(h=this.equalsBelow[r],u=this.equalsNorth[a],c=this.equalRows(r,a)),s===kt-1?l=a:d=this.equalsNorth[l]);const f=this.equalsWest[r],_=this.equalsWest[a],S=f>>>1|2147483648,p=_>>>1|2147483648,m=c&h&d&f&S&_&p;this.north[e]=r,this.below[e]=a,this.belowNorth[e]=o,this.belowSouth[e]=l,this.same[e]=c,this.upright[e]=h,this.level[e]=u,this.levelSouth[e]=d,this.full[e]=m,this.copyBase(n,r,a,u);const{exceptions:y}=this,T=m===We?16:Gc(m&Xs);if(y.gap>=T?(y.gap-=T,this.quiet[e]=m===We?1:0):(this.takeExceptions(t,n,m&Xs,T),this.quiet[e]=0),m===We)return;const{voxels:M,contexts:A,places:E}=this;let g=this.coded;for(let w=~m&Xs;w!==0;w&=w-1){const N=31-Math.clz32(w&-w),C=(f>>>N&1)<<2|(S>>>N&1)<<3|(_>>>N&1)<<4|(p>>>N&1)<<5;if(c>>>N&1)A[g]=h>>>N&1|(d>>>N&1)<<1|C;else{const D=M[l*kt+N]===M[r*kt+N]?8:0;A[g]=64|u>>>N&1|(h>>>N&1)<<1|(d>>>N&1)<<2|D|((C&12)===12?16:0)|(C>=48?32:0)}E[g++]=e<<16|n*kt+N}this.coded=g}finishRow(t,e,n){const{voxels:s,exceptions:r,contexts:a,places:o}=this;if(this.quiet[e]){r.gap>=16?r.gap-=16:(this.quiet[e]=0,this.takeExceptions(t,n,Jp,16));return}const l=this.north[e]*kt,c=this.below[e]*kt,h=this.same[e],u=this.upright[e],d=this.level[e],f=this.levelSouth[e],_=this.full[e],S=this.equalsWest[this.north[e]],p=this.equalsWest[this.below[e]],m=n*kt;let y=0,T=this.coded,M=s[m];for(let E=1;E<kt;E+=2){const g=E===kt-1?M:s[m+E+1],w=s[l+E];if(M===g){s[m+E]=M;const N=h>>>E&1;if(N&&w===M)_>>>E&1?y|=1<<E:(a[T]=128|u>>>E&1|(f>>>E&1)<<1|(S>>>E&1)<<2|(E===kt-1?1:S>>>E+1&1)<<3|(p>>>E&1)<<4|(E===kt-1?1:p>>>E+1&1)<<5,o[T++]=e<<16|m+E);else{const C=s[c+E],D=d>>>E&1,B=D?w:C,V=D?C:w;a[T]=192|(B===M?1:0)|(V===M?2:0)|N<<2|(u>>>E&1)<<3|D<<4|(f>>>E&1)<<5,o[T++]=e<<16|m+E}}else{const N=s[c+E],C=d>>>E&1,D=C?w:N,B=C?N:w,V=D===g||D!==M&&B===g,L=V?g:M,H=V?M:g;s[m+E]=L,a[T]=256|(D===L?1:0)|(B===L?2:0)|(D===H?4:0)|(B===H?8:0)|(u>>>E&1)<<4|C<<5|(f>>>E&1)<<6,o[T++]=e<<16|m+E}M=g}this.coded=T;const A=Gc(y);r.gap>=A?r.gap-=A:this.takeExceptions(t,n,y,A)}takeExceptions(t,e,n,s){const{exceptions:r}=this;for(;r.gap<s;){for(let o=r.gap;o>0;--o)n&=n-1;const a=31-Math.clz32(n&-n);n&=n-1,s-=r.gap+1,this.voxels[e*kt+a]=r.take(t)}r.gap-=s}readBatch(t,e){const{contexts:n,places:s,voxels:r,escapes:a,coded:o}=this,{bytes:l,states:c}=t;let h=t.next,u=0,d=!1;for(let f=0;f<o;++f){const _=e[n[f]],S=f&pe-1;let p=c[S];const m=p&255,y=_&255;if(m<y)p=y*(p>>8)+m;else{const T=_>>8&255,M=_>>16,A=s[f];if(m>=M)p=(256-M)*(p>>8)+m-M,a[u++]=A&65535;else{let E=1;m<T?p=(T-y)*(p>>8)+m-y:(E=2,p=(M-T)*(p>>8)+m-T);const g=this.candidate(A,E);g<0?d=!0:r[A&65535]=g}}p<256&&(p=p<<8|l[h++]),c[S]=p}t.next=h;for(let f=0;f<u;++f)r[a[f]]=this.materials.read(t,f&pe-1);if(t.checkRead(),d)throw new zt("bad_number")}candidate(t,e){const n=t>>>16,s=t&65535;return qp(this.voxels,s&-32,this.north[n]*kt,this.below[n]*kt,this.belowNorth[n]*kt,this.belowSouth[n]*kt,s&kt-1,e)}copyBase(t,e,n,s){const{pairs:r,voxels:a}=this,o=t*(kt/2),l=(s===We?e:n)*(kt/2);for(let c=0;c<kt/2;++c)r[o+c]=r[l+c];if(s!==We)for(let c=s&Xs;c!==0;c&=c-1){const h=31-Math.clz32(c&-c);a[t*kt+h]=a[e*kt+h]}}compareRow(t,e){const n=this.north[t];if(this.quiet[t]){this.rowMaterial[e]=this.rowMaterial[n],this.equalsWest[e]=this.equalsNorth[e]=this.equalsBelow[e]=We;return}const{pairs:s}=this,r=e*(kt/2);let a=s[r]&65535,o=0;for(let l=0;l<kt/2;++l){const c=s[r+l],h=c&65535,u=c>>>16;o|=((h===a?1:0)|(u===h?2:0))<<2*l,a=u}this.equalsWest[e]=o,this.rowMaterial[e]=o===We?a:xa,this.equalsNorth[e]=this.equalRows(e,n),this.equalsBelow[e]=this.equalRows(e,this.below[t])}equalRows(t,e){const n=this.rowMaterial[t];if(n!==xa&&this.rowMaterial[e]!==xa)return n===this.rowMaterial[e]?We:0;const{pairs:s}=this,r=t*(kt/2),a=e*(kt/2);let o=0;for(let l=0;l<kt/2;++l){const c=s[r+l]^s[a+l];o|=(((c&65535)===0?1:0)|(c>>>16?0:2))<<2*l}return o}}function Gc(i){return i-=i>>>1&1431655765,i=(i&858993459)+(i>>>2&858993459),Math.imul(i+(i>>>4)&252645135,16843009)>>>24}const jp=32768,Cu=2*jp,xn=16,Ma=16,Hc=Cu/64,qs=Uint8Array.from("b8fe6c3923a44bbe7c01812cf721ad1cded46de9839097db7240a4a4b7b3671fcb79e64eccc0e578825ad07dccff7221b8084674f743248ee03590e6813a264c3c2852bb91c300cb88d0658b1b532ea371644897a20df94e3819ef46a9deacd8a8fa763fe39c343ff9dcbbc7c70b4f1d8a51e04bcdb45931c89f7ec9d9787364eac5ac8334d3ebc3c581a0fffa1363eb170ddd51b7f0da49d316552629d4689e2b16be587d47a1fc8ff8b8d17ad031ce45cb3a8f95160428afd7fbcabb4b407e".match(/../g),i=>parseInt(i,16));function os(i,t){return Int32Array.from({length:t},(e,n)=>{const s=i+4*n;return qs[s]|qs[s+1]<<8|qs[s+2]<<16|qs[s+3]<<24})}const tm=[3266489917,0,2246822535,2654435761,668265295,3266489917,2654435833,374761393,3266489955,2246822519,2246822519,0,374761413,668265263,2654435761,0],ya=-1640531535;class em{words=new Int32Array(Cu/4);voxels=new Uint16Array(this.words.buffer);sums=new Int32Array(16);stripeSecrets=os(0,xn+2*(Ma-1));lastSecret=os(121,xn);scrambleSecret=os(128,xn);lowSecret=os(11,xn);highSecret=os(117,xn);hash(){this.sums.set(tm);for(let n=0;n<Hc-1;++n){const s=n%Ma;this.accumulate(n*xn,this.stripeSecrets,2*s),s===Ma-1&&this.scramble()}this.accumulate((Hc-1)*xn,this.lastSecret,0);const t=this.merge(this.lowSecret,-897122304,2041677291);return this.merge(this.highSecret,347144191,1371723819)+t}accumulate(t,e,n){const{words:s,sums:r}=this;for(let a=0;a<xn;a+=2){const o=s[t+a],l=s[t+a+1],c=o^e[n+a],h=l^e[n+a+1],u=Math.imul(c&65535,h>>>16),d=Math.imul(c>>>16,h&65535),f=(Math.imul(c&65535,h&65535)>>>16)+(u&65535)+(d&65535),_=Math.imul(c,h),S=Math.imul(c>>>16,h>>>16)+(u>>>16)+(d>>>16)+(f>>>16);let p=r[a]+_|0;r[a+1]=r[a+1]+S+(wa(p,_)?1:0),r[a]=p;const m=a^2;p=r[m]+o|0,r[m+1]=r[m+1]+l+(wa(p,o)?1:0),r[m]=p}}scramble(){const{sums:t,scrambleSecret:e}=this;for(let n=0;n<xn;n+=2){const s=t[n+1],r=t[n]^s>>>15^e[n];t[n]=Math.imul(r,ya),t[n+1]=fo(r,ya)+Math.imul(s^e[n+1],ya)}}merge(t,e,n){const{sums:s}=this;let r=e|0,a=n|0;for(let l=0;l<xn;l+=4){const[c,h,u,d]=nm(s[l]^t[l],s[l+1]^t[l+1],s[l+2]^t[l+2],s[l+3]^t[l+3]),f=c^u;r=r+f|0,a=a+(h^d)+(wa(r,f)?1:0)|0}r^=a>>>5;const o=Math.imul(r,2654435833);return a=fo(r,-1640531463)+Math.imul(a,2654435833)+Math.imul(r,374761361)|0,r=o^a,Vc(a)+Vc(r)}}function wa(i,t){return(i^2147483648)<(t^2147483648)}function fo(i,t){const e=Math.imul(i&65535,t>>>16),n=Math.imul(i>>>16,t&65535),s=(Math.imul(i&65535,t&65535)>>>16)+(e&65535)+(n&65535);return Math.imul(i>>>16,t>>>16)+(e>>>16)+(n>>>16)+(s>>>16)|0}function nm(i,t,e,n){const s=[[0,i,e],[1,i,n],[1,t,e],[2,t,n]],r=[0,0,0,0,0];for(const[a,o,l]of s)r[a]+=Math.imul(o,l)>>>0,r[a+1]+=fo(o,l)>>>0;for(let a=0;a<4;++a)r[a+1]+=Math.floor(r[a]/4294967296),r[a]=r[a]|0;return[r[0],r[1],r[2],r[3]]}function Vc(i){return(i>>>0).toString(16).padStart(8,"0")}let $s;function im(i){return $s??=new em,i.voxels===null?$s.voxels.fill(i.uniform):$s.voxels.set(i.voxels),$s.hash()}const Br=32768;class sm{source=new Np;layers=new Up;volume=new Qp;runs=new Gp}let Wc;function rm(i,t={}){if(t.into!==void 0&&t.into.length!==Br)throw new RangeError(`decodeChunk: into must have ${Br} voxels, not ${t.into.length}`);const e=am(i,t.into);if(t.hash!=null&&im(e)!==t.hash)throw new zt("bad_hash");return e}function am(i,t){if(i.length===0)throw new zt("empty");const e=i[0];if(e!==3&&e!==4)throw new zt("unknown_version");if(i.length<2)throw new zt("truncated");if(i.length>pl)throw new zt("too_long");const n=i[1];if(n>3||(e===3?n===3:n===0))throw new zt("unknown_encoding");Wc??=new sm;const{source:s,layers:r,volume:a,runs:o}=Wc;s.begin(i);const l=e===3&&n===0;if(l){const h=r.decode(s);if(h!==null)return{uniform:h,voxels:null}}const c=t??new Uint16Array(Br);return l?r.expand(c):n===2?om(i,c):e===3?zp(s,c):n===1?a.decode(s,c):o.decode(s,c),{uniform:null,voxels:c}}function om(i,t){if(i.length<pl)throw new zt("truncated");for(let e=0;e<Br;++e)t[e]=i[2+2*e]|i[3+2*e]<<8}function lm(i){const t=new URL(i.url,globalThis.location?.href);if(t.search=t.hash="",t.protocol==="ws:"||t.protocol==="wss:")return t.pathname.endsWith("/v1/stream")||(t.pathname=`${t.pathname.replace(/\/$/,"")}/v1/stream`),new dp(i,pp(t.href,i.WebSocket));if(t.protocol==="http:"||t.protocol==="https:")return new Bf(i,t);throw new Wt("unreachable",`url ${i.url}: ws:, wss:, http: and https: are known here; tcp: and tls: in talus-client/node`)}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const gl="187",cm=0,Xc=1,hm=2,Ar=1,um=2,Ms=3,ci=0,Ve=1,bn=2,Zi=0,As=1,qc=2,$c=3,Yc=4,dm=5,$i=100,fm=101,pm=102,mm=103,gm=104,_m=200,vm=201,xm=202,Sm=203,Lu=204,Pu=205,Mm=206,ym=207,wm=208,Em=209,bm=210,Tm=211,Am=212,Rm=213,Cm=214,po=0,mo=1,go=2,Ls=3,_o=4,vo=5,xo=6,So=7,Iu=0,Lm=1,Pm=2,Vn=0,Du=1,Nu=2,Uu=3,Fu=4,Ou=5,ku=6,Bu=7,zu=300,Qi=301,Ps=302,Ea=303,ba=304,zr=1e3,Gn=1001,Mo=1002,xe=1003,Im=1004,Ys=1005,Fe=1006,Ta=1007,oi=1008,en=1009,Gu=1010,Hu=1011,Is=1012,_l=1013,an=1014,sn=1015,gn=1016,vl=1017,xl=1018,ji=1020,Vu=35902,Wu=35899,Xu=1021,qu=1022,rn=1023,hi=1026,li=1027,$u=1028,Sl=1029,ui=1030,Qr=1031,Ml=1033,Rr=33776,Cr=33777,Lr=33778,Pr=33779,yo=35840,wo=35841,Eo=35842,bo=35843,To=36196,Ao=37492,Ro=37496,Co=37488,Lo=37489,Gr=37490,Po=37491,Io=37808,Do=37809,No=37810,Uo=37811,Fo=37812,Oo=37813,ko=37814,Bo=37815,zo=37816,Go=37817,Ho=37818,Vo=37819,Wo=37820,Xo=37821,qo=36492,$o=36494,Yo=36495,Ko=36283,Zo=36284,Hr=36285,Jo=36286,Dm=3200,Kc=0,Nm=1,ai="",tn="srgb",Vr="srgb-linear",Wr="linear",ne="srgb",Aa=7680,Um=519,Fm=512,Om=513,km=514,yl=515,Bm=516,zm=517,Yu=518,Ku=519,Gm=35044,Ki="300 es",pn=2e3,Xr=2001;function Hm(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function qr(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Vm(){const i=qr("canvas");return i.style.display="block",i}const Zc={};function Jc(...i){const t="THREE."+i.shift();console.log(t,...i)}function Zu(i){const t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){const e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ct(...i){i=Zu(i);const t="THREE."+i.shift();{const e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function Qt(...i){i=Zu(i);const t="THREE."+i.shift();{const e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function Ir(...i){const t=i.join(" ");t in Zc||(Zc[t]=!0,Ct(...i))}function Wm(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}const Xm={[po]:po,[go]:xo,[_o]:_o,[Ls]:vo,[mo]:mo,[xo]:go,[So]:So,[vo]:Ls};class Di{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});const n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){const n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){const n=this._listeners;if(n===void 0)return;const s=n[t];if(s!==void 0){const r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){const e=this._listeners;if(e===void 0)return;const n=e[t.type];if(n!==void 0){t.target=this;const s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,t);t.target=null}}}const Ne=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Ra=Math.PI/180,Qo=180/Math.PI;function Ns(){const i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Ne[i&255]+Ne[i>>8&255]+Ne[i>>16&255]+Ne[i>>24&255]+"-"+Ne[t&255]+Ne[t>>8&255]+"-"+Ne[t>>16&15|64]+Ne[t>>24&255]+"-"+Ne[e&63|128]+Ne[e>>8&255]+"-"+Ne[e>>16&255]+Ne[e>>24&255]+Ne[n&255]+Ne[n>>8&255]+Ne[n>>16&255]+Ne[n>>24&255]).toLowerCase()}function Xt(i,t,e){return Math.max(t,Math.min(e,i))}function qm(i,t){return(i%t+t)%t}function Ca(i,t,e){return(1-e)*i+e*t}function $m(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function wl(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Ym(i,t){if(t.constructor===Float32Array)return i;const e=wl(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Km(i,t){if(t.constructor===Float32Array)return i;const e=wl(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}class Zt{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){const e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Xt(this.x,t.x,e.x),this.y=Xt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Xt(this.x,t,e),this.y=Xt(this.y,t,e),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Xt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(Xt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){const n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,a=this.y-t.y;return this.x=r*n-a*s+t.x,this.y=r*s+a*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class is{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,a,o){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[a+0],f=r[a+1],_=r[a+2],S=r[a+3];if(u!==S||l!==d||c!==f||h!==_){let p=l*d+c*f+h*_+u*S;p<0&&(d=-d,f=-f,_=-_,S=-S,p=-p);let m=1-o;if(p<.9995){const y=Math.acos(p),T=Math.sin(y);m=Math.sin(m*y)/T,o=Math.sin(o*y)/T,l=l*m+d*o,c=c*m+f*o,h=h*m+_*o,u=u*m+S*o}else{l=l*m+d*o,c=c*m+f*o,h=h*m+_*o,u=u*m+S*o;const y=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=y,c*=y,h*=y,u*=y}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,a){const o=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[a],d=r[a+1],f=r[a+2],_=r[a+3];return t[e]=o*_+h*u+l*f-c*d,t[e+1]=l*_+h*d+c*u-o*f,t[e+2]=c*_+h*f+o*d-l*u,t[e+3]=h*_-o*u-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){const n=t._x,s=t._y,r=t._z,a=t._order,o=Math.cos,l=Math.sin,c=o(n/2),h=o(s/2),u=o(r/2),d=l(n/2),f=l(s/2),_=l(r/2);switch(a){case"XYZ":this._x=d*h*u+c*f*_,this._y=c*f*u-d*h*_,this._z=c*h*_+d*f*u,this._w=c*h*u-d*f*_;break;case"YXZ":this._x=d*h*u+c*f*_,this._y=c*f*u-d*h*_,this._z=c*h*_-d*f*u,this._w=c*h*u+d*f*_;break;case"ZXY":this._x=d*h*u-c*f*_,this._y=c*f*u+d*h*_,this._z=c*h*_+d*f*u,this._w=c*h*u-d*f*_;break;case"ZYX":this._x=d*h*u-c*f*_,this._y=c*f*u+d*h*_,this._z=c*h*_-d*f*u,this._w=c*h*u+d*f*_;break;case"YZX":this._x=d*h*u+c*f*_,this._y=c*f*u+d*h*_,this._z=c*h*_-d*f*u,this._w=c*h*u-d*f*_;break;case"XZY":this._x=d*h*u-c*f*_,this._y=c*f*u-d*h*_,this._z=c*h*_+d*f*u,this._w=c*h*u+d*f*_;break;default:Ct("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){const n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){const e=t.elements,n=e[0],s=e[4],r=e[8],a=e[1],o=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=n+o+u;if(d>0){const f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(a-s)*f}else if(n>o&&n>u){const f=2*Math.sqrt(1+n-o-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+a)/f,this._z=(r+c)/f}else if(o>u){const f=2*Math.sqrt(1+o-n-u);this._w=(r-c)/f,this._x=(s+a)/f,this._y=.25*f,this._z=(l+h)/f}else{const f=2*Math.sqrt(1+u-n-o);this._w=(a-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Xt(this.dot(t),-1,1)))}rotateTowards(t,e){const n=this.angleTo(t);if(n===0)return this;const s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){const n=t._x,s=t._y,r=t._z,a=t._w,o=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+a*o+s*c-r*l,this._y=s*h+a*l+r*o-n*c,this._z=r*h+a*c+n*l-s*o,this._w=a*h-n*o-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,a=t._w,o=this.dot(t);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let l=1-e;if(o<.9995){const c=Math.acos(o),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+a*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+a*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){const t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class O{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Qc.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Qc.setFromAxisAngle(t,e))}applyMatrix3(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=t.elements,a=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(t){const e=this.x,n=this.y,s=this.z,r=t.x,a=t.y,o=t.z,l=t.w,c=2*(a*s-o*n),h=2*(o*e-r*s),u=2*(r*n-a*e);return this.x=e+l*c+a*u-o*h,this.y=n+l*h+o*c-r*u,this.z=s+l*u+r*h-a*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Xt(this.x,t.x,e.x),this.y=Xt(this.y,t.y,e.y),this.z=Xt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Xt(this.x,t,e),this.y=Xt(this.y,t,e),this.z=Xt(this.z,t,e),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Xt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){const n=t.x,s=t.y,r=t.z,a=e.x,o=e.y,l=e.z;return this.x=s*l-r*o,this.y=r*a-n*l,this.z=n*o-s*a,this}projectOnVector(t){const e=t.lengthSq();if(e===0)return this.set(0,0,0);const n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return La.copy(this).projectOnVector(t),this.sub(La)}reflect(t){return this.sub(La.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(Xt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){const s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){const e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const La=new O,Qc=new is;class Pt{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,l,c)}set(t,e,n,s,r,a,o,l,c){const h=this.elements;return h[0]=t,h[1]=s,h[2]=o,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){const e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],_=n[8],S=s[0],p=s[3],m=s[6],y=s[1],T=s[4],M=s[7],A=s[2],E=s[5],g=s[8];return r[0]=a*S+o*y+l*A,r[3]=a*p+o*T+l*E,r[6]=a*m+o*M+l*g,r[1]=c*S+h*y+u*A,r[4]=c*p+h*T+u*E,r[7]=c*m+h*M+u*g,r[2]=d*S+f*y+_*A,r[5]=d*p+f*T+_*E,r[8]=d*m+f*M+_*g,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8];return e*a*h-e*o*c-n*r*h+n*o*l+s*r*c-s*a*l}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8],u=h*a-o*c,d=o*l-h*r,f=c*r-a*l,_=e*u+n*d+s*f;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);const S=1/_;return t[0]=u*S,t[1]=(s*c-h*n)*S,t[2]=(o*n-s*a)*S,t[3]=d*S,t[4]=(h*e-s*l)*S,t[5]=(s*r-o*e)*S,t[6]=f*S,t[7]=(n*l-c*e)*S,t[8]=(a*e-n*r)*S,this}transpose(){let t;const e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){const e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,a,o){const l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*a+c*o)+a+t,-s*c,s*l,-s*(-c*a+l*o)+o+e,0,0,1),this}scale(t,e){return Ir("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Pa.makeScale(t,e)),this}rotate(t){return Ir("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Pa.makeRotation(-t)),this}translate(t,e){return Ir("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Pa.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}}const Pa=new Pt,jc=new Pt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),th=new Pt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Zm(){const i={enabled:!0,workingColorSpace:Vr,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===ne&&(s.r=Wn(s.r),s.g=Wn(s.g),s.b=Wn(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===ne&&(s.r=Ji(s.r),s.g=Ji(s.g),s.b=Ji(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ai?Wr:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Vr]:{primaries:t,whitePoint:n,transfer:Wr,toXYZ:jc,fromXYZ:th,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:tn},outputColorSpaceConfig:{drawingBufferColorSpace:tn}},[tn]:{primaries:t,whitePoint:n,transfer:ne,toXYZ:jc,fromXYZ:th,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:tn}}}),i}const $t=Zm();function Wn(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Ji(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}let Ni;class Jm{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Ni===void 0&&(Ni=qr("canvas")),Ni.width=t.width,Ni.height=t.height;const s=Ni.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Ni}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){const e=qr("canvas");e.width=t.width,e.height=t.height;const n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);const s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=Wn(r[a]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){const e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Wn(e[n]/255)*255):e[n]=Wn(e[n]);return{data:e,width:t.width,height:t.height}}else return Ct("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}}let Qm=0;class El{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Qm++}),this.uuid=Ns(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){const e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];const n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(Ia(s[a].image)):r.push(Ia(s[a]))}else r=Ia(s);n.url=r}return e||(t.images[this.uuid]=n),n}}function Ia(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Jm.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ct("Texture: Unable to serialize Texture."),{})}let jm=0;const Da=new O;class Be extends Di{constructor(t=Be.DEFAULT_IMAGE,e=Be.DEFAULT_MAPPING,n=Gn,s=Gn,r=Fe,a=oi,o=rn,l=en,c=Be.DEFAULT_ANISOTROPY,h=ai){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:jm++}),this.uuid=Ns(),this.name="",this.source=new El(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new Zt(0,0),this.repeat=new Zt(1,1),this.center=new Zt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Pt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Da).x}get height(){return this.source.getSize(Da).y}get depth(){return this.source.getSize(Da).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(const e in t){const n=t[e];if(n===void 0){Ct(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){Ct(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];const n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==zu)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case zr:t.x=t.x-Math.floor(t.x);break;case Gn:t.x=t.x<0?0:1;break;case Mo:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case zr:t.y=t.y-Math.floor(t.y);break;case Gn:t.y=t.y<0?0:1;break;case Mo:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}}Be.DEFAULT_IMAGE=null;Be.DEFAULT_MAPPING=zu;Be.DEFAULT_ANISOTROPY=1;class de{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=this.w,a=t.elements;return this.x=a[0]*e+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*e+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*e+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*e+a[7]*n+a[11]*s+a[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);const e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r;const l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],_=l[9],S=l[2],p=l[6],m=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-S)<.01&&Math.abs(_-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+S)<.1&&Math.abs(_+p)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;const T=(c+1)/2,M=(f+1)/2,A=(m+1)/2,E=(h+d)/4,g=(u+S)/4,w=(_+p)/4;return T>M&&T>A?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=E/n,r=g/n):M>A?M<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=E/s,r=w/s):A<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),n=g/r,s=w/r),this.set(n,s,r,e),this}let y=Math.sqrt((p-_)*(p-_)+(u-S)*(u-S)+(d-h)*(d-h));return Math.abs(y)<.001&&(y=1),this.x=(p-_)/y,this.y=(u-S)/y,this.z=(d-h)/y,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Xt(this.x,t.x,e.x),this.y=Xt(this.y,t.y,e.y),this.z=Xt(this.z,t.z,e.z),this.w=Xt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Xt(this.x,t,e),this.y=Xt(this.y,t,e),this.z=Xt(this.z,t,e),this.w=Xt(this.w,t,e),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Xt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class t0 extends Di{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Fe,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new de(0,0,t,e),this.scissorTest=!1,this.viewport=new de(0,0,t,e),this.textures=[];const s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Be({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){const e={minFilter:Fe,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;const s=Object.assign({},t.textures[e].image);this.textures[e].source=new El(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){const e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}}class mn extends t0{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}}class bl extends Be{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=xe,this.minFilter=xe,this.wrapR=Gn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}}class e0 extends Be{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=xe,this.minFilter=xe,this.wrapR=Gn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}}class jt{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,a,o,l,c,h,u,d,f,_,S,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,l,c,h,u,d,f,_,S,p)}set(t,e,n,s,r,a,o,l,c,h,u,d,f,_,S,p){const m=this.elements;return m[0]=t,m[4]=e,m[8]=n,m[12]=s,m[1]=r,m[5]=a,m[9]=o,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=_,m[11]=S,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new jt().fromArray(this.elements)}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){const e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){const e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();const e=this.elements,n=t.elements,s=1/Ui.setFromMatrixColumn(t,0).length(),r=1/Ui.setFromMatrixColumn(t,1).length(),a=1/Ui.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*a,e[9]=n[9]*a,e[10]=n[10]*a,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){const e=this.elements,n=t.x,s=t.y,r=t.z,a=Math.cos(n),o=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){const d=a*h,f=a*u,_=o*h,S=o*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=f+_*c,e[5]=d-S*c,e[9]=-o*l,e[2]=S-d*c,e[6]=_+f*c,e[10]=a*l}else if(t.order==="YXZ"){const d=l*h,f=l*u,_=c*h,S=c*u;e[0]=d+S*o,e[4]=_*o-f,e[8]=a*c,e[1]=a*u,e[5]=a*h,e[9]=-o,e[2]=f*o-_,e[6]=S+d*o,e[10]=a*l}else if(t.order==="ZXY"){const d=l*h,f=l*u,_=c*h,S=c*u;e[0]=d-S*o,e[4]=-a*u,e[8]=_+f*o,e[1]=f+_*o,e[5]=a*h,e[9]=S-d*o,e[2]=-a*c,e[6]=o,e[10]=a*l}else if(t.order==="ZYX"){const d=a*h,f=a*u,_=o*h,S=o*u;e[0]=l*h,e[4]=_*c-f,e[8]=d*c+S,e[1]=l*u,e[5]=S*c+d,e[9]=f*c-_,e[2]=-c,e[6]=o*l,e[10]=a*l}else if(t.order==="YZX"){const d=a*l,f=a*c,_=o*l,S=o*c;e[0]=l*h,e[4]=S-d*u,e[8]=_*u+f,e[1]=u,e[5]=a*h,e[9]=-o*h,e[2]=-c*h,e[6]=f*u+_,e[10]=d-S*u}else if(t.order==="XZY"){const d=a*l,f=a*c,_=o*l,S=o*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+S,e[5]=a*h,e[9]=f*u-_,e[2]=_*u-f,e[6]=o*h,e[10]=S*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(n0,t,i0)}lookAt(t,e,n){const s=this.elements;return Xe.subVectors(t,e),Xe.lengthSq()===0&&(Xe.z=1),Xe.normalize(),Qn.crossVectors(n,Xe),Qn.lengthSq()===0&&(Math.abs(n.z)===1?Xe.x+=1e-4:Xe.z+=1e-4,Xe.normalize(),Qn.crossVectors(n,Xe)),Qn.normalize(),Ks.crossVectors(Xe,Qn),s[0]=Qn.x,s[4]=Ks.x,s[8]=Xe.x,s[1]=Qn.y,s[5]=Ks.y,s[9]=Xe.y,s[2]=Qn.z,s[6]=Ks.z,s[10]=Xe.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],_=n[2],S=n[6],p=n[10],m=n[14],y=n[3],T=n[7],M=n[11],A=n[15],E=s[0],g=s[4],w=s[8],N=s[12],C=s[1],D=s[5],B=s[9],V=s[13],L=s[2],H=s[6],$=s[10],G=s[14],tt=s[3],X=s[7],Q=s[11],j=s[15];return r[0]=a*E+o*C+l*L+c*tt,r[4]=a*g+o*D+l*H+c*X,r[8]=a*w+o*B+l*$+c*Q,r[12]=a*N+o*V+l*G+c*j,r[1]=h*E+u*C+d*L+f*tt,r[5]=h*g+u*D+d*H+f*X,r[9]=h*w+u*B+d*$+f*Q,r[13]=h*N+u*V+d*G+f*j,r[2]=_*E+S*C+p*L+m*tt,r[6]=_*g+S*D+p*H+m*X,r[10]=_*w+S*B+p*$+m*Q,r[14]=_*N+S*V+p*G+m*j,r[3]=y*E+T*C+M*L+A*tt,r[7]=y*g+T*D+M*H+A*X,r[11]=y*w+T*B+M*$+A*Q,r[15]=y*N+T*V+M*G+A*j,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],a=t[1],o=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],f=t[14],_=t[3],S=t[7],p=t[11],m=t[15],y=l*f-c*d,T=o*f-c*u,M=o*d-l*u,A=a*f-c*h,E=a*d-l*h,g=a*u-o*h;return e*(S*y-p*T+m*M)-n*(_*y-p*A+m*E)+s*(_*T-S*A+m*g)-r*(_*M-S*E+p*g)}determinantAffine(){const t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],a=t[5],o=t[9],l=t[2],c=t[6],h=t[10];return e*(a*h-o*c)-n*(r*h-o*l)+s*(r*c-a*l)}transpose(){const t=this.elements;let e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){const s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],_=t[12],S=t[13],p=t[14],m=t[15],y=e*o-n*a,T=e*l-s*a,M=e*c-r*a,A=n*l-s*o,E=n*c-r*o,g=s*c-r*l,w=h*S-u*_,N=h*p-d*_,C=h*m-f*_,D=u*p-d*S,B=u*m-f*S,V=d*m-f*p,L=y*V-T*B+M*D+A*C-E*N+g*w;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const H=1/L;return t[0]=(o*V-l*B+c*D)*H,t[1]=(s*B-n*V-r*D)*H,t[2]=(S*g-p*E+m*A)*H,t[3]=(d*E-u*g-f*A)*H,t[4]=(l*C-a*V-c*N)*H,t[5]=(e*V-s*C+r*N)*H,t[6]=(p*M-_*g-m*T)*H,t[7]=(h*g-d*M+f*T)*H,t[8]=(a*B-o*C+c*w)*H,t[9]=(n*C-e*B-r*w)*H,t[10]=(_*E-S*M+m*y)*H,t[11]=(u*M-h*E-f*y)*H,t[12]=(o*N-a*D-l*w)*H,t[13]=(e*D-n*N+s*w)*H,t[14]=(S*T-_*A-p*y)*H,t[15]=(h*A-u*T+d*y)*H,this}scale(t){const e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){const t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){const e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){const n=Math.cos(e),s=Math.sin(e),r=1-n,a=t.x,o=t.y,l=t.z,c=r*a,h=r*o;return this.set(c*a+n,c*o-s*l,c*l+s*o,0,c*o+s*l,h*o+n,h*l-s*a,0,c*l-s*o,h*l+s*a,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,a){return this.set(1,n,r,0,t,1,a,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){const s=this.elements,r=e._x,a=e._y,o=e._z,l=e._w,c=r+r,h=a+a,u=o+o,d=r*c,f=r*h,_=r*u,S=a*h,p=a*u,m=o*u,y=l*c,T=l*h,M=l*u,A=n.x,E=n.y,g=n.z;return s[0]=(1-(S+m))*A,s[1]=(f+M)*A,s[2]=(_-T)*A,s[3]=0,s[4]=(f-M)*E,s[5]=(1-(d+m))*E,s[6]=(p+y)*E,s[7]=0,s[8]=(_+T)*g,s[9]=(p-y)*g,s[10]=(1-(d+S))*g,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){const s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];const r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let a=Ui.set(s[0],s[1],s[2]).length();const o=Ui.set(s[4],s[5],s[6]).length(),l=Ui.set(s[8],s[9],s[10]).length();r<0&&(a=-a),ln.copy(this);const c=1/a,h=1/o,u=1/l;return ln.elements[0]*=c,ln.elements[1]*=c,ln.elements[2]*=c,ln.elements[4]*=h,ln.elements[5]*=h,ln.elements[6]*=h,ln.elements[8]*=u,ln.elements[9]*=u,ln.elements[10]*=u,e.setFromRotationMatrix(ln),n.x=a,n.y=o,n.z=l,this}makePerspective(t,e,n,s,r,a,o=pn,l=!1){const c=this.elements,h=2*r/(e-t),u=2*r/(n-s),d=(e+t)/(e-t),f=(n+s)/(n-s);let _,S;if(l)_=r/(a-r),S=a*r/(a-r);else if(o===pn)_=-(a+r)/(a-r),S=-2*a*r/(a-r);else if(o===Xr)_=-a/(a-r),S=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=_,c[14]=S,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,a,o=pn,l=!1){const c=this.elements,h=2/(e-t),u=2/(n-s),d=-(e+t)/(e-t),f=-(n+s)/(n-s);let _,S;if(l)_=1/(a-r),S=a/(a-r);else if(o===pn)_=-2/(a-r),S=-(a+r)/(a-r);else if(o===Xr)_=-1/(a-r),S=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=_,c[14]=S,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}}const Ui=new O,ln=new jt,n0=new O(0,0,0),i0=new O(1,1,1),Qn=new O,Ks=new O,Xe=new O,eh=new jt,nh=new is;class Li{constructor(t=0,e=0,n=0,s=Li.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){const s=t.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Xt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Xt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(Xt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Xt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(Xt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(o,f));break;case"XZY":this._z=Math.asin(-Xt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ct("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return eh.makeRotationFromQuaternion(t),this.setFromRotationMatrix(eh,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return nh.setFromEuler(this),this.setFromQuaternion(nh,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}Li.DEFAULT_ORDER="XYZ";class Ju{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}}let s0=0;const ih=new O,Fi=new is,Pn=new jt,Zs=new O,ls=new O,r0=new O,a0=new is,sh=new O(1,0,0),rh=new O(0,1,0),ah=new O(0,0,1),oh={type:"added"},o0={type:"removed"},Oi={type:"childadded",child:null},Na={type:"childremoved",child:null};class Ye extends Di{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:s0++}),this.uuid=Ns(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=Ye.DEFAULT_UP.clone();const t=new O,e=new Li,n=new is,s=new O(1,1,1);function r(){n.setFromEuler(e,!1)}function a(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new jt},normalMatrix:{value:new Pt}}),this.matrix=new jt,this.matrixWorld=new jt,this.matrixAutoUpdate=Ye.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=Ye.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ju,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Fi.setFromAxisAngle(t,e),this.quaternion.multiply(Fi),this}rotateOnWorldAxis(t,e){return Fi.setFromAxisAngle(t,e),this.quaternion.premultiply(Fi),this}rotateX(t){return this.rotateOnAxis(sh,t)}rotateY(t){return this.rotateOnAxis(rh,t)}rotateZ(t){return this.rotateOnAxis(ah,t)}translateOnAxis(t,e){return ih.copy(t).applyQuaternion(this.quaternion),this.position.add(ih.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(sh,t)}translateY(t){return this.translateOnAxis(rh,t)}translateZ(t){return this.translateOnAxis(ah,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Pn.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Zs.copy(t):Zs.set(t,e,n);const s=this.parent;this.updateWorldMatrix(!0,!1),ls.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Pn.lookAt(ls,Zs,this.up):Pn.lookAt(Zs,ls,this.up),this.quaternion.setFromRotationMatrix(Pn),s&&(Pn.extractRotation(s.matrixWorld),Fi.setFromRotationMatrix(Pn),this.quaternion.premultiply(Fi.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Qt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(oh),Oi.child=t,this.dispatchEvent(Oi),Oi.child=null):Qt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}const e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(o0),Na.child=t,this.dispatchEvent(Na),Na.child=null),this}removeFromParent(){const t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Pn.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Pn.multiply(t.parent.matrixWorld)),t.applyMatrix4(Pn),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(oh),Oi.child=t,this.dispatchEvent(Oi),Oi.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){const a=this.children[n].getObjectByProperty(t,e);if(a!==void 0)return a}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);const s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ls,t,r0),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ls,a0,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);const e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){const e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);const t=this.pivot;if(t!==null){const e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){const s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){const r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(t){const e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);const o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){const l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){const u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(t.materials,this.material[l]));s.material=o}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){const l=this.animations[o];s.animations.push(r(t.animations,l))}}if(e){const o=a(t.geometries),l=a(t.materials),c=a(t.textures),h=a(t.images),u=a(t.shapes),d=a(t.skeletons),f=a(t.animations),_=a(t.nodes);o.length>0&&(n.geometries=o),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),_.length>0&&(n.nodes=_)}return n.object=s,n;function a(o){const l=[];for(const c in o){const h=o[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){const s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}}Ye.DEFAULT_UP=new O(0,1,0);Ye.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ye.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;class Js extends Ye{constructor(){super(),this.isGroup=!0,this.type="Group"}}const l0={type:"move"};class Ua{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Js,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Js,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new O,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new O),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Js,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new O,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new O,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){const e=this._hand;if(e)for(const n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,a=null;const o=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){a=!0;for(const S of t.hand.values()){const p=e.getJointPose(S,n),m=this._getHandJoint(c,S);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}const h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,_=.005;c.inputState.pinching&&d>f+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));o!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(l0)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){const n=new Js;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}}const Qu={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},jn={h:0,s:0,l:0},Qs={h:0,s:0,l:0};function Fa(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}class Yt{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){const s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=tn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,$t.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=$t.workingColorSpace){return this.r=t,this.g=e,this.b=n,$t.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=$t.workingColorSpace){if(t=qm(t,1),e=Xt(e,0,1),n=Xt(n,0,1),e===0)this.r=this.g=this.b=n;else{const r=n<=.5?n*(1+e):n+e-n*e,a=2*n-r;this.r=Fa(a,r,t+1/3),this.g=Fa(a,r,t),this.b=Fa(a,r,t-1/3)}return $t.colorSpaceToWorking(this,s),this}setStyle(t,e=tn){function n(r){r!==void 0&&parseFloat(r)<1&&Ct("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r;const a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Ct("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){const r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(a===6)return this.setHex(parseInt(r,16),e);Ct("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=tn){const n=Qu[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Ct("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Wn(t.r),this.g=Wn(t.g),this.b=Wn(t.b),this}copyLinearToSRGB(t){return this.r=Ji(t.r),this.g=Ji(t.g),this.b=Ji(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=tn){return $t.workingToColorSpace(Ue.copy(this),t),Math.round(Xt(Ue.r*255,0,255))*65536+Math.round(Xt(Ue.g*255,0,255))*256+Math.round(Xt(Ue.b*255,0,255))}getHexString(t=tn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=$t.workingColorSpace){$t.workingToColorSpace(Ue.copy(this),e);const n=Ue.r,s=Ue.g,r=Ue.b,a=Math.max(n,s,r),o=Math.min(n,s,r);let l,c;const h=(o+a)/2;if(o===a)l=0,c=0;else{const u=a-o;switch(c=h<=.5?u/(a+o):u/(2-a-o),a){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=$t.workingColorSpace){return $t.workingToColorSpace(Ue.copy(this),e),t.r=Ue.r,t.g=Ue.g,t.b=Ue.b,t}getStyle(t=tn){$t.workingToColorSpace(Ue.copy(this),t);const e=Ue.r,n=Ue.g,s=Ue.b;return t!==tn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(jn),this.setHSL(jn.h+t,jn.s+e,jn.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(jn),t.getHSL(Qs);const n=Ca(jn.h,Qs.h,e),s=Ca(jn.s,Qs.s,e),r=Ca(jn.l,Qs.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){const e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const Ue=new Yt;Yt.NAMES=Qu;class Dr extends Ye{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Li,this.environmentIntensity=1,this.environmentRotation=new Li,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){const e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}}const cn=new O,In=new O,Oa=new O,Dn=new O,ki=new O,Bi=new O,lh=new O,ka=new O,Ba=new O,za=new O,Ga=new de,Ha=new de,Va=new de;class fn{constructor(t=new O,e=new O,n=new O){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),cn.subVectors(t,e),s.cross(cn);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){cn.subVectors(s,e),In.subVectors(n,e),Oa.subVectors(t,e);const a=cn.dot(cn),o=cn.dot(In),l=cn.dot(Oa),c=In.dot(In),h=In.dot(Oa),u=a*c-o*o;if(u===0)return r.set(0,0,0),null;const d=1/u,f=(c*l-o*h)*d,_=(a*h-o*l)*d;return r.set(1-f-_,_,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Dn)===null?!1:Dn.x>=0&&Dn.y>=0&&Dn.x+Dn.y<=1}static getInterpolation(t,e,n,s,r,a,o,l){return this.getBarycoord(t,e,n,s,Dn)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Dn.x),l.addScaledVector(a,Dn.y),l.addScaledVector(o,Dn.z),l)}static getInterpolatedAttribute(t,e,n,s,r,a){return Ga.setScalar(0),Ha.setScalar(0),Va.setScalar(0),Ga.fromBufferAttribute(t,e),Ha.fromBufferAttribute(t,n),Va.fromBufferAttribute(t,s),a.setScalar(0),a.addScaledVector(Ga,r.x),a.addScaledVector(Ha,r.y),a.addScaledVector(Va,r.z),a}static isFrontFacing(t,e,n,s){return cn.subVectors(n,e),In.subVectors(t,e),cn.cross(In).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return cn.subVectors(this.c,this.b),In.subVectors(this.a,this.b),cn.cross(In).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return fn.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return fn.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return fn.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return fn.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return fn.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){const n=this.a,s=this.b,r=this.c;let a,o;ki.subVectors(s,n),Bi.subVectors(r,n),ka.subVectors(t,n);const l=ki.dot(ka),c=Bi.dot(ka);if(l<=0&&c<=0)return e.copy(n);Ba.subVectors(t,s);const h=ki.dot(Ba),u=Bi.dot(Ba);if(h>=0&&u<=h)return e.copy(s);const d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return a=l/(l-h),e.copy(n).addScaledVector(ki,a);za.subVectors(t,r);const f=ki.dot(za),_=Bi.dot(za);if(_>=0&&f<=_)return e.copy(r);const S=f*c-l*_;if(S<=0&&c>=0&&_<=0)return o=c/(c-_),e.copy(n).addScaledVector(Bi,o);const p=h*_-f*u;if(p<=0&&u-h>=0&&f-_>=0)return lh.subVectors(r,s),o=(u-h)/(u-h+(f-_)),e.copy(s).addScaledVector(lh,o);const m=1/(p+S+d);return a=S*m,o=d*m,e.copy(n).addScaledVector(ki,a).addScaledVector(Bi,o)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}}class Us{constructor(t=new O(1/0,1/0,1/0),e=new O(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(hn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(hn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){const n=hn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);const n=t.geometry;if(n!==void 0){const r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)t.isMesh===!0?t.getVertexPosition(a,hn):hn.fromBufferAttribute(r,a),hn.applyMatrix4(t.matrixWorld),this.expandByPoint(hn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),js.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),js.copy(n.boundingBox)),js.applyMatrix4(t.matrixWorld),this.union(js)}const s=t.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,hn),hn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(cs),tr.subVectors(this.max,cs),zi.subVectors(t.a,cs),Gi.subVectors(t.b,cs),Hi.subVectors(t.c,cs),ti.subVectors(Gi,zi),ei.subVectors(Hi,Gi),xi.subVectors(zi,Hi);let e=[0,-ti.z,ti.y,0,-ei.z,ei.y,0,-xi.z,xi.y,ti.z,0,-ti.x,ei.z,0,-ei.x,xi.z,0,-xi.x,-ti.y,ti.x,0,-ei.y,ei.x,0,-xi.y,xi.x,0];return!Wa(e,zi,Gi,Hi,tr)||(e=[1,0,0,0,1,0,0,0,1],!Wa(e,zi,Gi,Hi,tr))?!1:(er.crossVectors(ti,ei),e=[er.x,er.y,er.z],Wa(e,zi,Gi,Hi,tr))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,hn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(hn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Nn[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Nn[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Nn[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Nn[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Nn[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Nn[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Nn[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Nn[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Nn),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}}const Nn=[new O,new O,new O,new O,new O,new O,new O,new O],hn=new O,js=new Us,zi=new O,Gi=new O,Hi=new O,ti=new O,ei=new O,xi=new O,cs=new O,tr=new O,er=new O,Si=new O;function Wa(i,t,e,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){Si.fromArray(i,r);const o=s.x*Math.abs(Si.x)+s.y*Math.abs(Si.y)+s.z*Math.abs(Si.z),l=t.dot(Si),c=e.dot(Si),h=n.dot(Si);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}const zn=c0();function c0(){const i=new ArrayBuffer(4),t=new Float32Array(i),e=new Uint32Array(i),n=new Uint32Array(512),s=new Uint32Array(512);for(let l=0;l<256;++l){const c=l-127;c<-27?(n[l]=0,n[l|256]=32768,s[l]=24,s[l|256]=24):c<-14?(n[l]=1024>>-c-14,n[l|256]=1024>>-c-14|32768,s[l]=-c-1,s[l|256]=-c-1):c<=15?(n[l]=c+15<<10,n[l|256]=c+15<<10|32768,s[l]=13,s[l|256]=13):c<128?(n[l]=31744,n[l|256]=64512,s[l]=24,s[l|256]=24):(n[l]=31744,n[l|256]=64512,s[l]=13,s[l|256]=13)}const r=new Uint32Array(2048),a=new Uint32Array(64),o=new Uint32Array(64);for(let l=1;l<1024;++l){let c=l<<13,h=0;for(;(c&8388608)===0;)c<<=1,h-=8388608;c&=-8388609,h+=947912704,r[l]=c|h}for(let l=1024;l<2048;++l)r[l]=939524096+(l-1024<<13);for(let l=1;l<31;++l)a[l]=l<<23;a[31]=1199570944,a[32]=2147483648;for(let l=33;l<63;++l)a[l]=2147483648+(l-32<<23);a[63]=3347054592;for(let l=1;l<64;++l)l!==32&&(o[l]=1024);return{floatView:t,uint32View:e,baseTable:n,shiftTable:s,mantissaTable:r,exponentTable:a,offsetTable:o}}function h0(i){Math.abs(i)>65504&&Ct("DataUtils.toHalfFloat(): Value out of range."),i=Xt(i,-65504,65504),zn.floatView[0]=i;const t=zn.uint32View[0],e=t>>23&511;return zn.baseTable[e]+((t&8388607)>>zn.shiftTable[e])}function u0(i){const t=i>>10;return zn.uint32View[0]=zn.mantissaTable[zn.offsetTable[t]+(i&1023)]+zn.exponentTable[t],zn.floatView[0]}class ju{static toHalfFloat(t){return h0(t)}static fromHalfFloat(t){return u0(t)}}const _e=new O,nr=new Zt;let d0=0;class Xn extends Di{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:d0++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Gm,this.updateRanges=[],this.gpuType=sn,this.version=0,this._normalizationScale=t!==void 0?wl(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)nr.fromBufferAttribute(this,e),nr.applyMatrix3(t),this.setXY(e,nr.x,nr.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)_e.fromBufferAttribute(this,e),_e.applyMatrix3(t),this.setXYZ(e,_e.x,_e.y,_e.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)_e.fromBufferAttribute(this,e),_e.applyMatrix4(t),this.setXYZ(e,_e.x,_e.y,_e.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)_e.fromBufferAttribute(this,e),_e.applyNormalMatrix(t),this.setXYZ(e,_e.x,_e.y,_e.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)_e.fromBufferAttribute(this,e),_e.transformDirection(t),this.setXYZ(e,_e.x,_e.y,_e.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){const e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Ym(t,this.array)}_normalize(t){const e=this._normalizationScale;return e!==void 0?Math.round(t*e):Km(t,this.array)}}class td extends Xn{constructor(t,e,n){super(new Uint16Array(t),e,n)}}class ed extends Xn{constructor(t,e,n){super(new Uint32Array(t),e,n)}}class qn extends Xn{constructor(t,e,n){super(new Float32Array(t),e,n)}}const f0=new Us,hs=new O,Xa=new O;class Tl{constructor(t=new O,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){const n=this.center;e!==void 0?n.copy(e):f0.setFromPoints(t).getCenter(n);let s=0;for(let r=0,a=t.length;r<a;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){const e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){const n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;hs.subVectors(t,this.center);const e=hs.lengthSq();if(e>this.radius*this.radius){const n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(hs,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Xa.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(hs.copy(t.center).add(Xa)),this.expandByPoint(hs.copy(t.center).sub(Xa))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}}let p0=0;const je=new jt,qa=new Ye,Vi=new O,qe=new Us,us=new Us,Ae=new O;class Yn extends Di{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:p0++}),this.uuid=Ns(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Hm(t)?ed:td)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){const e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);const n=this.attributes.normal;if(n!==void 0){const r=new Pt().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return je.makeRotationFromQuaternion(t),this.applyMatrix4(je),this}rotateX(t){return je.makeRotationX(t),this.applyMatrix4(je),this}rotateY(t){return je.makeRotationY(t),this.applyMatrix4(je),this}rotateZ(t){return je.makeRotationZ(t),this.applyMatrix4(je),this}translate(t,e,n){return je.makeTranslation(t,e,n),this.applyMatrix4(je),this}scale(t,e,n){return je.makeScale(t,e,n),this.applyMatrix4(je),this}lookAt(t){return qa.lookAt(t),qa.updateMatrix(),this.applyMatrix4(qa.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Vi).negate(),this.translate(Vi.x,Vi.y,Vi.z),this}setFromPoints(t){const e=this.getAttribute("position");if(e===void 0){const n=[];for(let s=0,r=t.length;s<r;s++){const a=t[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new qn(n,3))}else{const n=Math.min(t.length,e.count);for(let s=0;s<n;s++){const r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Ct("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Us);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Qt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new O(-1/0,-1/0,-1/0),new O(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){const r=e[n];qe.setFromBufferAttribute(r),this.morphTargetsRelative?(Ae.addVectors(this.boundingBox.min,qe.min),this.boundingBox.expandByPoint(Ae),Ae.addVectors(this.boundingBox.max,qe.max),this.boundingBox.expandByPoint(Ae)):(this.boundingBox.expandByPoint(qe.min),this.boundingBox.expandByPoint(qe.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Tl);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Qt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new O,1/0);return}if(t){const n=this.boundingSphere.center;if(qe.setFromBufferAttribute(t),e)for(let r=0,a=e.length;r<a;r++){const o=e[r];us.setFromBufferAttribute(o),this.morphTargetsRelative?(Ae.addVectors(qe.min,us.min),qe.expandByPoint(Ae),Ae.addVectors(qe.max,us.max),qe.expandByPoint(Ae)):(qe.expandByPoint(us.min),qe.expandByPoint(us.max))}qe.getCenter(n);let s=0;for(let r=0,a=t.count;r<a;r++)Ae.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Ae));if(e)for(let r=0,a=e.length;r<a;r++){const o=e[r],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)Ae.fromBufferAttribute(o,c),l&&(Vi.fromBufferAttribute(t,c),Ae.add(Vi)),s=Math.max(s,n.distanceToSquared(Ae))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Qt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const n=e.position,s=e.normal,r=e.uv;let a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new Xn(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));const o=[],l=[],c=new Uint8Array(n.count);for(let N=0;N<n.count;N++)o[N]=new O,l[N]=new O;const h=new O,u=new O,d=new O,f=new Zt,_=new Zt,S=new Zt,p=new O,m=new O;function y(N,C,D){c[N]=c[C]=c[D]=1,h.fromBufferAttribute(n,N),u.fromBufferAttribute(n,C),d.fromBufferAttribute(n,D),f.fromBufferAttribute(r,N),_.fromBufferAttribute(r,C),S.fromBufferAttribute(r,D),u.sub(h),d.sub(h),_.sub(f),S.sub(f);const B=1/(_.x*S.y-S.x*_.y);isFinite(B)&&(p.copy(u).multiplyScalar(S.y).addScaledVector(d,-_.y).multiplyScalar(B),m.copy(d).multiplyScalar(_.x).addScaledVector(u,-S.x).multiplyScalar(B),o[N].add(p),o[C].add(p),o[D].add(p),l[N].add(m),l[C].add(m),l[D].add(m))}let T=this.groups;T.length===0&&(T=[{start:0,count:t.count}]);for(let N=0,C=T.length;N<C;++N){const D=T[N],B=D.start,V=D.count;for(let L=B,H=B+V;L<H;L+=3)y(t.getX(L+0),t.getX(L+1),t.getX(L+2))}const M=new O,A=new O,E=new O,g=new O;function w(N){E.fromBufferAttribute(s,N),g.copy(E);const C=o[N];M.copy(C),M.sub(E.multiplyScalar(E.dot(C))).normalize(),A.crossVectors(g,C);const B=A.dot(l[N])<0?-1:1;a.setXYZW(N,M.x,M.y,M.z,B)}for(let N=0,C=n.count;N<C;++N)c[N]&&w(N);this._transformed=!0}computeVertexNormals(){const t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Xn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);const s=new O,r=new O,a=new O,o=new O,l=new O,c=new O,h=new O,u=new O;if(t)for(let d=0,f=t.count;d<f;d+=3){const _=t.getX(d+0),S=t.getX(d+1),p=t.getX(d+2);s.fromBufferAttribute(e,_),r.fromBufferAttribute(e,S),a.fromBufferAttribute(e,p),h.subVectors(a,r),u.subVectors(s,r),h.cross(u),o.fromBufferAttribute(n,_),l.fromBufferAttribute(n,S),c.fromBufferAttribute(n,p),o.add(h),l.add(h),c.add(h),n.setXYZ(_,o.x,o.y,o.z),n.setXYZ(S,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),a.fromBufferAttribute(e,d+2),h.subVectors(a,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){const t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Ae.fromBufferAttribute(t,e),Ae.normalize(),t.setXYZ(e,Ae.x,Ae.y,Ae.z)}toNonIndexed(){function t(o,l){const c=o.array,h=o.itemSize,u=o.normalized,d=new c.constructor(l.length*h);let f=0,_=0;for(let S=0,p=l.length;S<p;S++){o.isInterleavedBufferAttribute?f=l[S]*o.data.stride+o.offset:f=l[S]*h;for(let m=0;m<h;m++)d[_++]=c[f++]}return new Xn(d,h,u)}if(this.index===null)return Ct("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const e=new Yn,n=this.index.array,s=this.attributes;for(const o in s){const l=s[o],c=t(l,n);e.setAttribute(o,c)}const r=this.morphAttributes;for(const o in r){const l=[],c=r[o];for(let h=0,u=c.length;h<u;h++){const d=c[h],f=t(d,n);l.push(f)}e.morphAttributes[o]=l}e.morphTargetsRelative=this.morphTargetsRelative;const a=this.groups;for(let o=0,l=a.length;o<l;o++){const c=a[o];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){const t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};const e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});const n=this.attributes;for(const l in n){const c=n[l];t.data.attributes[l]=c.toJSON(t.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){const f=c[u];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);const a=this.groups;a.length>0&&(t.data.groups=JSON.parse(JSON.stringify(a)));const o=this.boundingSphere;return o!==null&&(t.data.boundingSphere=o.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const e={};this.name=t.name;const n=t.index;n!==null&&this.setIndex(n.clone());const s=t.attributes;for(const c in s){const h=s[c];this.setAttribute(c,h.clone(e))}const r=t.morphAttributes;for(const c in r){const h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;const a=t.groups;for(let c=0,h=a.length;c<h;c++){const u=a[c];this.addGroup(u.start,u.count,u.materialIndex)}const o=t.boundingBox;o!==null&&(this.boundingBox=o.clone());const l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}}const $a=new O,m0=new O,g0=new Pt;class ri{constructor(t=new O(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){const s=$a.subVectors(n,e).cross(m0.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){const t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){const s=t.delta($a),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;const a=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:e.copy(t.start).addScaledVector(s,a)}intersectsLine(t){const e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){const n=e||g0.getNormalMatrix(t),s=this.coplanarPoint($a).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}}let _0=0;class jr extends Di{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:_0++}),this.uuid=Ns(),this.name="",this.type="Material",this.blending=As,this.side=ci,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Lu,this.blendDst=Pu,this.blendEquation=$i,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Yt(0,0,0),this.blendAlpha=0,this.depthFunc=Ls,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Um,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Aa,this.stencilZFail=Aa,this.stencilZPass=Aa,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(const e in t){const n=t[e];if(n===void 0){Ct(`Material: parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){Ct(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){const e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});const n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){const a=[];for(const o in r){const l=r[o];delete l.metadata,a.push(l)}return a}if(e){const r=s(t.textures),a=s(t.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Yt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new ri().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Zt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Zt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;const e=t.clippingPlanes;let n=null;if(e!==null){const s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}}const Un=new O,Ya=new O,ir=new O,sr=new O;class v0{constructor(t=new O,e=new O(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Un)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);const n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){const e=Un.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Un.copy(this.origin).addScaledVector(this.direction,e),Un.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Ya.copy(t).add(e).multiplyScalar(.5),ir.copy(e).sub(t).normalize(),sr.copy(this.origin).sub(Ya);const r=t.distanceTo(e)*.5,a=-this.direction.dot(ir),o=sr.dot(this.direction),l=-sr.dot(ir),c=sr.lengthSq(),h=Math.abs(1-a*a);let u,d,f,_;if(h>0)if(u=a*l-o,d=a*o-l,_=r*h,u>=0)if(d>=-_)if(d<=_){const S=1/h;u*=S,d*=S,f=u*(u+a*d+2*o)+d*(a*u+d+2*l)+c}else d=r,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*l)+c;else d<=-_?(u=Math.max(0,-(-a*r+o)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=_?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(a*r+o)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=a>0?-r:r,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Ya).addScaledVector(ir,d),f}intersectSphere(t,e){if(t.radius<0)return null;Un.subVectors(t.center,this.origin);const n=Un.dot(this.direction),s=Un.dot(Un)-n*n,r=t.radius*t.radius;if(s>r)return null;const a=Math.sqrt(r-s),o=n-a,l=n+a;return l<0?null:o<0?this.at(l,e):this.at(o,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){const e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;const n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){const n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){const e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,a,o,l;const c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(n=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,a=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,a=(t.min.y-d.y)*h),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),u>=0?(o=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(o=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),n>l||o>s)||((o>n||n!==n)&&(n=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Un)!==null}intersectTriangle(t,e,n,s,r){const a=this.origin,o=this.direction,l=o.x,c=o.y,h=o.z,u=t.x-a.x,d=t.y-a.y,f=t.z-a.z,_=e.x-a.x,S=e.y-a.y,p=e.z-a.z,m=n.x-a.x,y=n.y-a.y,T=n.z-a.z,M=Math.abs(l),A=Math.abs(c),E=Math.abs(h);let g,w,N,C,D,B,V,L,H,$,G,tt;if(M>=A&&M>=E?(N=l,B=u,H=_,tt=m,l>=0?(g=c,w=h,C=d,D=f,V=S,L=p,$=y,G=T):(g=h,w=c,C=f,D=d,V=p,L=S,$=T,G=y)):A>=E?(N=c,B=d,H=S,tt=y,c>=0?(g=h,w=l,C=f,D=u,V=p,L=_,$=T,G=m):(g=l,w=h,C=u,D=f,V=_,L=p,$=m,G=T)):(N=h,B=f,H=p,tt=T,h>=0?(g=l,w=c,C=u,D=d,V=_,L=S,$=m,G=y):(g=c,w=l,C=d,D=u,V=S,L=_,$=y,G=m)),N===0)return null;const X=g/N,Q=w/N,j=1/N,yt=C-X*B,It=D-Q*B,K=V-X*H,pt=L-Q*H,vt=$-X*tt,Tt=G-Q*tt,mt=vt*pt-Tt*K,Nt=yt*Tt-It*vt,me=K*It-pt*yt;if(s){if(mt<0||Nt<0||me<0)return null}else if((mt<0||Nt<0||me<0)&&(mt>0||Nt>0||me>0))return null;const Rt=mt+Nt+me;if(Rt===0)return null;const te=j*(mt*B+Nt*H+me*tt);return(Rt>0?te<0:te>0)?null:this.at(te/Rt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class x0 extends jr{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Yt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Li,this.combine=Iu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}}const ch=new jt,Mi=new v0,rr=new Tl,hh=new O,ar=new O,or=new O,lr=new O,Ka=new O,cr=new O,uh=new O,hr=new O;class $n extends Ye{constructor(t=new Yn,e=new x0){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){const o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(t,e){const n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;e.fromBufferAttribute(s,t);const o=this.morphTargetInfluences;if(r&&o){cr.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const h=o[l],u=r[l];h!==0&&(Ka.fromBufferAttribute(u,t),a?cr.addScaledVector(Ka,h):cr.addScaledVector(Ka.sub(e),h))}e.add(cr)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){const n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),rr.copy(n.boundingSphere),rr.applyMatrix4(r),Mi.copy(t.ray).recast(t.near),!(rr.containsPoint(Mi.origin)===!1&&(Mi.intersectSphere(rr,hh)===null||Mi.origin.distanceToSquared(hh)>(t.far-t.near)**2))&&(ch.copy(r).invert(),Mi.copy(t.ray).applyMatrix4(ch),!(n.boundingBox!==null&&Mi.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Mi)))}_computeIntersections(t,e,n){let s;const r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(o!==null)if(Array.isArray(a))for(let _=0,S=d.length;_<S;_++){const p=d[_],m=a[p.materialIndex],y=Math.max(p.start,f.start),T=Math.min(o.count,Math.min(p.start+p.count,f.start+f.count));for(let M=y,A=T;M<A;M+=3){const E=o.getX(M),g=o.getX(M+1),w=o.getX(M+2);s=ur(this,m,t,n,c,h,u,E,g,w),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{const _=Math.max(0,f.start),S=Math.min(o.count,f.start+f.count);for(let p=_,m=S;p<m;p+=3){const y=o.getX(p),T=o.getX(p+1),M=o.getX(p+2);s=ur(this,a,t,n,c,h,u,y,T,M),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let _=0,S=d.length;_<S;_++){const p=d[_],m=a[p.materialIndex],y=Math.max(p.start,f.start),T=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let M=y,A=T;M<A;M+=3){const E=M,g=M+1,w=M+2;s=ur(this,m,t,n,c,h,u,E,g,w),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{const _=Math.max(0,f.start),S=Math.min(l.count,f.start+f.count);for(let p=_,m=S;p<m;p+=3){const y=p,T=p+1,M=p+2;s=ur(this,a,t,n,c,h,u,y,T,M),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}}function S0(i,t,e,n,s,r,a,o){let l;if(t.side===Ve?l=n.intersectTriangle(a,r,s,!0,o):l=n.intersectTriangle(s,r,a,t.side===ci,o),l===null)return null;hr.copy(o),hr.applyMatrix4(i.matrixWorld);const c=e.ray.origin.distanceTo(hr);return c<e.near||c>e.far?null:{distance:c,point:hr.clone(),object:i}}function ur(i,t,e,n,s,r,a,o,l,c){i.getVertexPosition(o,ar),i.getVertexPosition(l,or),i.getVertexPosition(c,lr);const h=S0(i,t,e,n,ar,or,lr,uh);if(h){const u=new O;fn.getBarycoord(uh,ar,or,lr,u),s&&(h.uv=fn.getInterpolatedAttribute(s,o,l,c,u,new Zt)),r&&(h.uv1=fn.getInterpolatedAttribute(r,o,l,c,u,new Zt)),a&&(h.normal=fn.getInterpolatedAttribute(a,o,l,c,u,new O),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));const d={a:o,b:l,c,normal:new O,materialIndex:0};fn.getNormal(ar,or,lr,d.normal),h.face=d,h.barycoord=u}return h}class ta extends Be{constructor(t=null,e=1,n=1,s,r,a,o,l,c=xe,h=xe,u,d){super(null,a,o,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}const yi=new Tl,M0=new Zt(.5,.5),dr=new O;class $r{constructor(t=new ri,e=new ri,n=new ri,s=new ri,r=new ri,a=new ri){this.planes=[t,e,n,s,r,a]}set(t,e,n,s,r,a){const o=this.planes;return o[0].copy(t),o[1].copy(e),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(t){const e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=pn,n=!1){const s=this.planes,r=t.elements,a=r[0],o=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],_=r[8],S=r[9],p=r[10],m=r[11],y=r[12],T=r[13],M=r[14],A=r[15];if(s[0].setComponents(c-a,f-h,m-_,A-y).normalize(),s[1].setComponents(c+a,f+h,m+_,A+y).normalize(),s[2].setComponents(c+o,f+u,m+S,A+T).normalize(),s[3].setComponents(c-o,f-u,m-S,A-T).normalize(),n)s[4].setComponents(l,d,p,M).normalize(),s[5].setComponents(c-l,f-d,m-p,A-M).normalize();else if(s[4].setComponents(c-l,f-d,m-p,A-M).normalize(),e===pn)s[5].setComponents(c+l,f+d,m+p,A+M).normalize();else if(e===Xr)s[5].setComponents(l,d,p,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),yi.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{const e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),yi.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(yi)}intersectsSprite(t){yi.center.set(0,0,0);const e=M0.distanceTo(t.center);return yi.radius=.7071067811865476+e,yi.applyMatrix4(t.matrixWorld),this.intersectsSphere(yi)}intersectsSphere(t){const e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){const e=this.planes;for(let n=0;n<6;n++){const s=e[n];if(dr.x=s.normal.x>0?t.max.x:t.min.x,dr.y=s.normal.y>0?t.max.y:t.min.y,dr.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(dr)<0)return!1}return!0}containsPoint(t){const e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}const dh=new jt;class Al{constructor(){this.coordinateSystem=pn,this._frustums=[],this._count=0}setFromArrayCamera(t){const e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){const r=e[s];dh.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new $r),n[s].setFromProjectionMatrix(dh,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){const e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){const e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){const e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){const e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){const e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;const e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new $r),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new Al().copy(this)}}class nd extends Be{constructor(t=[],e=Qi,n,s,r,a,o,l,c,h){super(t,e,n,s,r,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}}class Pi extends Be{constructor(t,e,n=an,s,r,a,o=xe,l=xe,c,h=hi,u=1){if(h!==hi&&h!==li)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");const d={width:t,height:e,depth:u};super(d,s,r,a,o,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new El(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){const e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}}class id extends Pi{constructor(t,e=an,n=Qi,s,r,a=xe,o=xe,l,c=hi){const h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,a,o,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}}class sd extends Be{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}}class Fs extends Yn{constructor(t=1,e=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};const o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);const l=[],c=[],h=[],u=[];let d=0,f=0;_("z","y","x",-1,-1,n,e,t,a,r,0),_("z","y","x",1,-1,n,e,-t,a,r,1),_("x","z","y",1,1,t,n,e,s,a,2),_("x","z","y",1,-1,t,n,-e,s,a,3),_("x","y","z",1,-1,t,e,n,s,r,4),_("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new qn(c,3)),this.setAttribute("normal",new qn(h,3)),this.setAttribute("uv",new qn(u,2));function _(S,p,m,y,T,M,A,E,g,w,N){const C=M/g,D=A/w,B=M/2,V=A/2,L=E/2,H=g+1,$=w+1;let G=0,tt=0;const X=new O;for(let Q=0;Q<$;Q++){const j=Q*D-V;for(let yt=0;yt<H;yt++){const It=yt*C-B;X[S]=It*y,X[p]=j*T,X[m]=L,c.push(X.x,X.y,X.z),X[S]=0,X[p]=0,X[m]=E>0?1:-1,h.push(X.x,X.y,X.z),u.push(yt/g),u.push(1-Q/w),G+=1}}for(let Q=0;Q<w;Q++)for(let j=0;j<g;j++){const yt=d+j+H*Q,It=d+j+H*(Q+1),K=d+(j+1)+H*(Q+1),pt=d+(j+1)+H*Q;l.push(yt,It,pt),l.push(It,K,pt),tt+=6}o.addGroup(f,tt,N),f+=tt,d+=G}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Fs(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}}class ea extends Yn{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};const r=t/2,a=e/2,o=Math.floor(n),l=Math.floor(s),c=o+1,h=l+1,u=t/o,d=e/l,f=[],_=[],S=[],p=[];for(let m=0;m<h;m++){const y=m*d-a;for(let T=0;T<c;T++){const M=T*u-r;_.push(M,-y,0),S.push(0,0,1),p.push(T/o),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let y=0;y<o;y++){const T=y+c*m,M=y+c*(m+1),A=y+1+c*(m+1),E=y+1+c*m;f.push(T,M,E),f.push(M,A,E)}this.setIndex(f),this.setAttribute("position",new qn(_,3)),this.setAttribute("normal",new qn(S,3)),this.setAttribute("uv",new qn(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new ea(t.width,t.height,t.widthSegments,t.heightSegments)}}function ts(i){const t={};for(const e in i){t[e]={};for(const n in i[e]){const s=i[e][n];if(fh(s))s.isRenderTargetTexture?(Ct("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(fh(s[0])){const r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function ke(i){const t={};for(let e=0;e<i.length;e++){const n=ts(i[e]);for(const s in n)t[s]=n[s]}return t}function fh(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function y0(i){const t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function rd(i){const t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:$t.workingColorSpace}const w0={clone:ts,merge:ke};var E0=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,b0=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class Ii extends jr{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=E0,this.fragmentShader=b0,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=ts(t.uniforms),this.uniformsGroups=y0(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){const e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(const s in this.uniforms){const a=this.uniforms[s].value;a&&a.isTexture?e.uniforms[s]={type:"t",value:a.toJSON(t).uuid}:a&&a.isColor?e.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?e.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?e.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?e.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?e.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?e.uniforms[s]={type:"m4",value:a.toArray()}:e.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;const n={};for(const s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(const n in t.uniforms){const s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new Yt().setHex(s.value);break;case"v2":this.uniforms[n].value=new Zt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new O().fromArray(s.value);break;case"v4":this.uniforms[n].value=new de().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Pt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new jt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(const n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}}class ys extends Ii{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}}class T0 extends jr{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Dm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}}class A0 extends jr{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}}const fr=new O,pr=new is,Sn=new O;class ad extends Ye{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new jt,this.projectionMatrix=new jt,this.projectionMatrixInverse=new jt,this.coordinateSystem=pn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(fr,pr,Sn),Sn.x===1&&Sn.y===1&&Sn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(fr,pr,Sn.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(fr,pr,Sn),Sn.x===1&&Sn.y===1&&Sn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(fr,pr,Sn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}}const ni=new O,ph=new Zt,mh=new Zt;class dn extends ad{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){const e=.5*this.getFilmHeight()/t;this.fov=Qo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){const t=Math.tan(Ra*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Qo*2*Math.atan(Math.tan(Ra*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){ni.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(ni.x,ni.y).multiplyScalar(-t/ni.z),ni.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(ni.x,ni.y).multiplyScalar(-t/ni.z)}getViewSize(t,e){return this.getViewBounds(t,ph,mh),e.subVectors(mh,ph)}setViewOffset(t,e,n,s,r,a){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=this.near;let e=t*Math.tan(Ra*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s;const a=this.view;if(this.view!==null&&this.view.enabled){const l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,e-=a.offsetY*n/c,s*=a.width/l,n*=a.height/c}const o=this.filmOffset;o!==0&&(r+=t*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}}class R0 extends ad{constructor(t=-1,e=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=n-t,a=n+t,o=s+e,l=s-e;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}}const Wi=-90,Xi=1;class jo extends Ye{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new dn(Wi,Xi,t,e);s.layers=this.layers,this.add(s);const r=new dn(Wi,Xi,t,e);r.layers=this.layers,this.add(r);const a=new dn(Wi,Xi,t,e);a.layers=this.layers,this.add(a);const o=new dn(Wi,Xi,t,e);o.layers=this.layers,this.add(o);const l=new dn(Wi,Xi,t,e);l.layers=this.layers,this.add(l);const c=new dn(Wi,Xi,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const t=this.coordinateSystem,e=this.children.concat(),[n,s,r,a,o,l]=e;for(const c of e)this.remove(c);if(t===pn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Xr)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(const c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();const{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());const[r,a,o,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),_=t.xr.enabled;t.xr.enabled=!1;const S=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=S,t.setRenderTarget(n,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=_,n.texture.needsPMREMUpdate=!0}}class C0 extends dn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}}function gh(i,t,e,n){const s=L0(n);switch(e){case Xu:return i*t;case $u:return i*t/s.components*s.byteLength;case Sl:return i*t/s.components*s.byteLength;case ui:return i*t*2/s.components*s.byteLength;case Qr:return i*t*2/s.components*s.byteLength;case qu:return i*t*3/s.components*s.byteLength;case rn:return i*t*4/s.components*s.byteLength;case Ml:return i*t*4/s.components*s.byteLength;case Rr:case Cr:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Lr:case Pr:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case wo:case bo:return Math.max(i,16)*Math.max(t,8)/4;case yo:case Eo:return Math.max(i,8)*Math.max(t,8)/2;case To:case Ao:case Co:case Lo:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Ro:case Gr:case Po:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Io:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Do:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case No:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Uo:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case Fo:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Oo:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case ko:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Bo:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case zo:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Go:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Ho:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Vo:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Wo:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Xo:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case qo:case $o:case Yo:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Ko:case Zo:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Hr:case Jo:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function L0(i){switch(i){case en:case Gu:return{byteLength:1,components:1};case Is:case Hu:case gn:return{byteLength:2,components:1};case vl:case xl:return{byteLength:2,components:4};case an:case _l:case sn:return{byteLength:4,components:1};case Vu:case Wu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:gl}}));typeof window<"u"&&(window.__THREE__?Ct("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=gl);/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function od(){let i=null,t=!1,e=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),e(r,a)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function P0(i){const t=new WeakMap;function e(o,l){const c=o.array,h=o.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),o.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:u}}function n(o,l,c){const h=l.array,u=l.updateRanges;if(i.bindBuffer(c,o),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,_)=>f.start-_.start);let d=0;for(let f=1;f<u.length;f++){const _=u[d],S=u[f];S.start<=_.start+_.count+1?_.count=Math.max(_.count,S.start+S.count-_.start):(++d,u[d]=S)}u.length=d+1;for(let f=0,_=u.length;f<_;f++){const S=u[f];i.bufferSubData(c,S.start*h.BYTES_PER_ELEMENT,h,S.start,S.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),t.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);const l=t.get(o);l&&(i.deleteBuffer(l.buffer),t.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){const h=t.get(o);(!h||h.version<o.version)&&t.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}const c=t.get(o);if(c===void 0)t.set(o,e(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var I0=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,D0=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,N0=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,U0=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,F0=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,O0=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,k0=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,B0=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,z0=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,G0=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,H0=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,V0=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,W0=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,X0=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,q0=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,$0=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Y0=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,K0=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Z0=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,J0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Q0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,j0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,tg=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,eg=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,ng=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,ig=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,sg=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,rg=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ag=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,og="gl_FragColor = linearToOutputTexel( gl_FragColor );",lg=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,cg=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,hg=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,ug=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,dg=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,fg=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,pg=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,mg=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,gg=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,_g=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,vg=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,xg=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Sg=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Mg=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,yg=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,wg=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Eg=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,bg=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Tg=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Ag=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Rg=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Cg=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Lg=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Pg=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Ig=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Dg=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Ng=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Ug=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Fg=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Og=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,kg=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Bg=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,zg=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Gg=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Hg=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Vg=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Wg=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Xg=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,qg=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,$g=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Yg=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Kg=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Zg=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Jg=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Qg=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,jg=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,t_=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,e_=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,n_=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,i_=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,s_=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,r_=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,a_=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,o_=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,l_=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,c_=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,h_=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,u_=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,d_=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,f_=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,p_=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,m_=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,g_=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,__=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,v_=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,x_=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,S_=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,M_=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,y_=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,w_=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,E_=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,b_=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,T_=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,A_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,R_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,C_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,L_=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const P_=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,I_=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,D_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,N_=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,U_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,F_=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,O_=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,k_=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,B_=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,z_=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,G_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,H_=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,V_=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,W_=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,X_=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,q_=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,$_=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Y_=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,K_=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Z_=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,J_=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Q_=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,j_=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,tv=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ev=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,nv=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,iv=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,sv=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,rv=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,av=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,ov=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,lv=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,cv=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,hv=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Ot={alphahash_fragment:I0,alphahash_pars_fragment:D0,alphamap_fragment:N0,alphamap_pars_fragment:U0,alphatest_fragment:F0,alphatest_pars_fragment:O0,aomap_fragment:k0,aomap_pars_fragment:B0,batching_pars_vertex:z0,batching_vertex:G0,begin_vertex:H0,beginnormal_vertex:V0,bsdfs:W0,iridescence_fragment:X0,bumpmap_pars_fragment:q0,clipping_planes_fragment:$0,clipping_planes_pars_fragment:Y0,clipping_planes_pars_vertex:K0,clipping_planes_vertex:Z0,color_fragment:J0,color_pars_fragment:Q0,color_pars_vertex:j0,color_vertex:tg,common:eg,defaultnormal_vertex:ng,displacementmap_pars_vertex:ig,displacementmap_vertex:sg,emissivemap_fragment:rg,emissivemap_pars_fragment:ag,colorspace_fragment:og,colorspace_pars_fragment:lg,envmap_fragment:cg,envmap_common_pars_fragment:hg,envmap_pars_fragment:ug,envmap_pars_vertex:dg,envmap_physical_pars_fragment:wg,envmap_vertex:fg,fog_vertex:pg,fog_pars_vertex:mg,fog_fragment:gg,fog_pars_fragment:_g,gradientmap_pars_fragment:vg,lightmap_pars_fragment:xg,lights_lambert_fragment:Sg,lights_lambert_pars_fragment:Mg,lights_pars_begin:yg,lights_toon_fragment:Eg,lights_toon_pars_fragment:bg,lights_phong_fragment:Tg,lights_phong_pars_fragment:Ag,lights_physical_fragment:Rg,lights_physical_pars_fragment:Cg,lights_fragment_begin:Lg,lights_fragment_maps:Pg,lights_fragment_end:Ig,lightprobes_pars_fragment:Dg,logdepthbuf_fragment:Ng,logdepthbuf_pars_fragment:Ug,logdepthbuf_pars_vertex:Fg,logdepthbuf_vertex:Og,map_fragment:kg,map_pars_fragment:Bg,map_particle_fragment:zg,map_particle_pars_fragment:Gg,metalnessmap_fragment:Hg,metalnessmap_pars_fragment:Vg,morphinstance_vertex:Wg,morphcolor_vertex:Xg,morphnormal_vertex:qg,morphtarget_pars_vertex:$g,morphtarget_vertex:Yg,normal_fragment_begin:Kg,normal_fragment_maps:Zg,normal_pars_fragment:Jg,normal_pars_vertex:Qg,normal_vertex:jg,normalmap_pars_fragment:t_,clearcoat_normal_fragment_begin:e_,clearcoat_normal_fragment_maps:n_,clearcoat_pars_fragment:i_,iridescence_pars_fragment:s_,opaque_fragment:r_,packing:a_,premultiplied_alpha_fragment:o_,project_vertex:l_,dithering_fragment:c_,dithering_pars_fragment:h_,roughnessmap_fragment:u_,roughnessmap_pars_fragment:d_,shadowmap_pars_fragment:f_,shadowmap_pars_vertex:p_,shadowmap_vertex:m_,shadowmask_pars_fragment:g_,skinbase_vertex:__,skinning_pars_vertex:v_,skinning_vertex:x_,skinnormal_vertex:S_,specularmap_fragment:M_,specularmap_pars_fragment:y_,tonemapping_fragment:w_,tonemapping_pars_fragment:E_,transmission_fragment:b_,transmission_pars_fragment:T_,uv_pars_fragment:A_,uv_pars_vertex:R_,uv_vertex:C_,worldpos_vertex:L_,background_vert:P_,background_frag:I_,backgroundCube_vert:D_,backgroundCube_frag:N_,cube_vert:U_,cube_frag:F_,depth_vert:O_,depth_frag:k_,distance_vert:B_,distance_frag:z_,equirect_vert:G_,equirect_frag:H_,linedashed_vert:V_,linedashed_frag:W_,meshbasic_vert:X_,meshbasic_frag:q_,meshlambert_vert:$_,meshlambert_frag:Y_,meshmatcap_vert:K_,meshmatcap_frag:Z_,meshnormal_vert:J_,meshnormal_frag:Q_,meshphong_vert:j_,meshphong_frag:tv,meshphysical_vert:ev,meshphysical_frag:nv,meshtoon_vert:iv,meshtoon_frag:sv,points_vert:rv,points_frag:av,shadow_vert:ov,shadow_frag:lv,sprite_vert:cv,sprite_frag:hv},ft={common:{diffuse:{value:new Yt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Pt},alphaMap:{value:null},alphaMapTransform:{value:new Pt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Pt}},envmap:{envMap:{value:null},envMapRotation:{value:new Pt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Pt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Pt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Pt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Pt},normalScale:{value:new Zt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Pt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Pt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Pt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Pt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Yt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Yt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Pt},alphaTest:{value:0},uvTransform:{value:new Pt}},sprite:{diffuse:{value:new Yt(16777215)},opacity:{value:1},center:{value:new Zt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Pt},alphaMap:{value:null},alphaMapTransform:{value:new Pt},alphaTest:{value:0}}},wn={basic:{uniforms:ke([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.fog]),vertexShader:Ot.meshbasic_vert,fragmentShader:Ot.meshbasic_frag},lambert:{uniforms:ke([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Yt(0)},envMapIntensity:{value:1}}]),vertexShader:Ot.meshlambert_vert,fragmentShader:Ot.meshlambert_frag},phong:{uniforms:ke([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Yt(0)},specular:{value:new Yt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Ot.meshphong_vert,fragmentShader:Ot.meshphong_frag},standard:{uniforms:ke([ft.common,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.roughnessmap,ft.metalnessmap,ft.fog,ft.lights,{emissive:{value:new Yt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Ot.meshphysical_vert,fragmentShader:Ot.meshphysical_frag},toon:{uniforms:ke([ft.common,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.gradientmap,ft.fog,ft.lights,{emissive:{value:new Yt(0)}}]),vertexShader:Ot.meshtoon_vert,fragmentShader:Ot.meshtoon_frag},matcap:{uniforms:ke([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,{matcap:{value:null}}]),vertexShader:Ot.meshmatcap_vert,fragmentShader:Ot.meshmatcap_frag},points:{uniforms:ke([ft.points,ft.fog]),vertexShader:Ot.points_vert,fragmentShader:Ot.points_frag},dashed:{uniforms:ke([ft.common,ft.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Ot.linedashed_vert,fragmentShader:Ot.linedashed_frag},depth:{uniforms:ke([ft.common,ft.displacementmap]),vertexShader:Ot.depth_vert,fragmentShader:Ot.depth_frag},normal:{uniforms:ke([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,{opacity:{value:1}}]),vertexShader:Ot.meshnormal_vert,fragmentShader:Ot.meshnormal_frag},sprite:{uniforms:ke([ft.sprite,ft.fog]),vertexShader:Ot.sprite_vert,fragmentShader:Ot.sprite_frag},background:{uniforms:{uvTransform:{value:new Pt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Ot.background_vert,fragmentShader:Ot.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Pt}},vertexShader:Ot.backgroundCube_vert,fragmentShader:Ot.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Ot.cube_vert,fragmentShader:Ot.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Ot.equirect_vert,fragmentShader:Ot.equirect_frag},distance:{uniforms:ke([ft.common,ft.displacementmap,{referencePosition:{value:new O},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Ot.distance_vert,fragmentShader:Ot.distance_frag},shadow:{uniforms:ke([ft.lights,ft.fog,{color:{value:new Yt(0)},opacity:{value:1}}]),vertexShader:Ot.shadow_vert,fragmentShader:Ot.shadow_frag}};wn.physical={uniforms:ke([wn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Pt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Pt},clearcoatNormalScale:{value:new Zt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Pt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Pt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Pt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Pt},sheen:{value:0},sheenColor:{value:new Yt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Pt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Pt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Pt},transmissionSamplerSize:{value:new Zt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Pt},attenuationDistance:{value:0},attenuationColor:{value:new Yt(0)},specularColor:{value:new Yt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Pt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Pt},anisotropyVector:{value:new Zt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Pt}}]),vertexShader:Ot.meshphysical_vert,fragmentShader:Ot.meshphysical_frag};const mr={r:0,b:0,g:0},uv=new jt,ld=new Pt;ld.set(-1,0,0,0,1,0,0,0,1);function dv(i,t,e,n,s,r){const a=new Yt(0);let o=s===!0?0:1,l,c,h=null,u=0,d=null;function f(y){let T=y.isScene===!0?y.background:null;if(T&&T.isTexture){const M=y.backgroundBlurriness>0;T=t.get(T,M)}return T}function _(y){let T=!1;const M=f(y);M===null?p(a,o):M&&M.isColor&&(p(M,1),T=!0);const A=i.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||T)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function S(y,T){const M=f(T);M&&M.isCubeTexture?(c===void 0&&(c=new $n(new Fs(1,1,1),new Ii({name:"BackgroundCubeMaterial",uniforms:ts(wn.backgroundCube.uniforms),vertexShader:wn.backgroundCube.vertexShader,fragmentShader:wn.backgroundCube.fragmentShader,side:Ve,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,E,g){this.matrixWorld.copyPosition(g.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(uv.makeRotationFromEuler(T.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(ld),c.material.toneMapped=$t.getTransfer(M.colorSpace)!==ne,(h!==M||u!==M.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=M,u=M.version,d=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new $n(new ea(2,2),new Ii({name:"BackgroundMaterial",uniforms:ts(wn.background.uniforms),vertexShader:wn.background.vertexShader,fragmentShader:wn.background.fragmentShader,side:ci,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=$t.getTransfer(M.colorSpace)!==ne,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||u!==M.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=M,u=M.version,d=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function p(y,T){y.getRGB(mr,rd(i)),e.buffers.color.setClear(mr.r,mr.g,mr.b,T,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(y,T=1){a.set(y),o=T,p(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(y){o=y,p(a,o)},render:_,addToRenderList:S,dispose:m}}function fv(i,t){const e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null);let r=s,a=!1;function o(D,B,V,L,H){let $=!1;const G=u(D,L,V,B);r!==G&&(r=G,c(r.object)),$=f(D,L,V,H),$&&_(D,L,V,H),H!==null&&t.update(H,i.ELEMENT_ARRAY_BUFFER),($||a)&&(a=!1,M(D,B,V,L),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(H).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function u(D,B,V,L){const H=L.wireframe===!0;let $=n[B.id];$===void 0&&($={},n[B.id]=$);const G=D.isInstancedMesh===!0?D.id:0;let tt=$[G];tt===void 0&&(tt={},$[G]=tt);let X=tt[V.id];X===void 0&&(X={},tt[V.id]=X);let Q=X[H];return Q===void 0&&(Q=d(l()),X[H]=Q),Q}function d(D){const B=[],V=[],L=[];for(let H=0;H<e;H++)B[H]=0,V[H]=0,L[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:V,attributeDivisors:L,object:D,attributes:{},index:null}}function f(D,B,V,L){const H=r.attributes,$=B.attributes;let G=0;const tt=V.getAttributes();for(const X in tt)if(tt[X].location>=0){const j=H[X];let yt=$[X];if(yt===void 0&&(X==="instanceMatrix"&&D.instanceMatrix&&(yt=D.instanceMatrix),X==="instanceColor"&&D.instanceColor&&(yt=D.instanceColor)),j===void 0||j.attribute!==yt||yt&&j.data!==yt.data)return!0;G++}return r.attributesNum!==G||r.index!==L}function _(D,B,V,L){const H={},$=B.attributes;let G=0;const tt=V.getAttributes();for(const X in tt)if(tt[X].location>=0){let j=$[X];j===void 0&&(X==="instanceMatrix"&&D.instanceMatrix&&(j=D.instanceMatrix),X==="instanceColor"&&D.instanceColor&&(j=D.instanceColor));const yt={};yt.attribute=j,j&&j.data&&(yt.data=j.data),H[X]=yt,G++}r.attributes=H,r.attributesNum=G,r.index=L}function S(){const D=r.newAttributes;for(let B=0,V=D.length;B<V;B++)D[B]=0}function p(D){m(D,0)}function m(D,B){const V=r.newAttributes,L=r.enabledAttributes,H=r.attributeDivisors;V[D]=1,L[D]===0&&(i.enableVertexAttribArray(D),L[D]=1),H[D]!==B&&(i.vertexAttribDivisor(D,B),H[D]=B)}function y(){const D=r.newAttributes,B=r.enabledAttributes;for(let V=0,L=B.length;V<L;V++)B[V]!==D[V]&&(i.disableVertexAttribArray(V),B[V]=0)}function T(D,B,V,L,H,$,G){G===!0?i.vertexAttribIPointer(D,B,V,H,$):i.vertexAttribPointer(D,B,V,L,H,$)}function M(D,B,V,L){S();const H=L.attributes,$=V.getAttributes(),G=B.defaultAttributeValues;for(const tt in $){const X=$[tt];if(X.location>=0){let Q=H[tt];if(Q===void 0&&(tt==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),tt==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){const j=Q.normalized,yt=Q.itemSize,It=t.get(Q);if(It===void 0)continue;const K=It.buffer,pt=It.type,vt=It.bytesPerElement,Tt=pt===i.INT||pt===i.UNSIGNED_INT||Q.gpuType===_l;if(Q.isInterleavedBufferAttribute){const mt=Q.data,Nt=mt.isInterleavedBuffer===!0?mt.stride:mt.itemSize,me=Q.offset;if(mt.isInstancedInterleavedBuffer||mt.isInstancedBufferAttribute){for(let Rt=0;Rt<X.locationSize;Rt++)m(X.location+Rt,mt.meshPerAttribute);D.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=mt.meshPerAttribute*mt.count)}else for(let Rt=0;Rt<X.locationSize;Rt++)p(X.location+Rt);i.bindBuffer(i.ARRAY_BUFFER,K);for(let Rt=0;Rt<X.locationSize;Rt++)T(X.location+Rt,yt/X.locationSize,pt,j,Nt*vt,(me+yt/X.locationSize*Rt)*vt,Tt)}else{if(Q.isInstancedBufferAttribute){for(let mt=0;mt<X.locationSize;mt++)m(X.location+mt,Q.meshPerAttribute);D.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let mt=0;mt<X.locationSize;mt++)p(X.location+mt);i.bindBuffer(i.ARRAY_BUFFER,K);for(let mt=0;mt<X.locationSize;mt++)T(X.location+mt,yt/X.locationSize,pt,j,yt*vt,yt/X.locationSize*mt*vt,Tt)}}else if(G!==void 0){const j=G[tt];if(j!==void 0)switch(j.length){case 2:i.vertexAttrib2fv(X.location,j);break;case 3:i.vertexAttrib3fv(X.location,j);break;case 4:i.vertexAttrib4fv(X.location,j);break;default:i.vertexAttrib1fv(X.location,j)}}}}y()}function A(){N();for(const D in n){const B=n[D];for(const V in B){const L=B[V];for(const H in L){const $=L[H];for(const G in $)h($[G].object),delete $[G];delete L[H]}}delete n[D]}}function E(D){if(n[D.id]===void 0)return;const B=n[D.id];for(const V in B){const L=B[V];for(const H in L){const $=L[H];for(const G in $)h($[G].object),delete $[G];delete L[H]}}delete n[D.id]}function g(D){for(const B in n){const V=n[B];for(const L in V){const H=V[L];if(H[D.id]===void 0)continue;const $=H[D.id];for(const G in $)h($[G].object),delete $[G];delete H[D.id]}}}function w(D){for(const B in n){const V=n[B],L=D.isInstancedMesh===!0?D.id:0,H=V[L];if(H!==void 0){for(const $ in H){const G=H[$];for(const tt in G)h(G[tt].object),delete G[tt];delete H[$]}delete V[L],Object.keys(V).length===0&&delete n[B]}}}function N(){C(),a=!0,r!==s&&(r=s,c(r.object))}function C(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:N,resetDefaultState:C,dispose:A,releaseStatesOfGeometry:E,releaseStatesOfObject:w,releaseStatesOfProgram:g,initAttributes:S,enableAttribute:p,disableUnusedAttributes:y}}function pv(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function a(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function o(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function mv(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){const g=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(g.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(g){return!(g!==rn&&n.convert(g)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(g){const w=g===gn&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(g!==en&&g!==sn&&!w&&n.convert(g)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(g){if(g==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";g="mediump"}return g==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp";const h=l(c);h!==c&&(Ct("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);const u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&Ct("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&Ct("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");const f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),S=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),A=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:_,maxTextureSize:S,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:y,maxVaryings:T,maxFragmentUniforms:M,maxSamples:A,samples:E}}function gv(i){const t=this;let e=null,n=0,s=!1,r=!1;const a=new ri,o=new Pt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){const f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){const _=u.clippingPlanes,S=u.clipIntersection,p=u.clipShadows,m=i.get(u);if(!s||_===null||_.length===0||r&&!p)r?h(null):c();else{const y=r?0:n,T=y*4;let M=m.clippingState||null;l.value=M,M=h(_,d,T,f);for(let A=0;A!==T;++A)M[A]=e[A];m.clippingState=M,this.numIntersection=S?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,d,f,_){const S=u!==null?u.length:0;let p=null;if(S!==0){if(p=l.value,_!==!0||p===null){const m=f+S*4,y=d.matrixWorldInverse;o.getNormalMatrix(y),(p===null||p.length<m)&&(p=new Float32Array(m));for(let T=0,M=f;T!==S;++T,M+=4)a.copy(u[T]).applyMatrix4(y,o),a.normal.toArray(p,M),p[M+3]=a.constant}l.value=p,l.needsUpdate=!0}return t.numPlanes=S,t.numIntersection=0,p}}class Rl extends mn{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;const n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new nd(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;const n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Fs(5,5,5),r=new Ii({name:"CubemapFromEquirect",uniforms:ts(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Ve,blending:Zi});r.uniforms.tEquirect.value=e;const a=new $n(s,r),o=e.minFilter;return e.minFilter===oi&&(e.minFilter=Fe),new jo(1,10,this).update(t,a),e.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){const r=t.getRenderTarget();for(let a=0;a<6;a++)t.setRenderTarget(this,a),t.clear(e,n,s);t.setRenderTarget(r)}}const _h=256,_v=3,vv=20,cd=256,hd=16,xv=3,Sv=new O,Mv=new Yt;class Yr{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new jo(1,10,null),this._boxMesh=new $n(new Fs(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){const{size:a=256,position:o=Sv}=r,l=this._renderer;this._setSize(a);const c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);const u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,_=l.autoClearStencil,S=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,S===null&&(t.background=l.getClearColor(Mv));const p=new jo(n,s,h);return p.position.copy(o),p.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=_,t.background=S,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Sh(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=xh(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(_h,$m(t))}_fromTexture(t,e){t.mapping===Qi||t.mapping===Ps?this._setSize(t.image.length===0?_h:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);const n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){const t=this._cubeSize,e=vh(t,!1,!1),n=Math.log2(t)-_v;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){const e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=vh(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){const s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;const a=t.width>>e;t.viewport.set(0,0,a,a),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Qi||t.mapping===Ps?(this._cubemapMaterial===null&&(this._cubemapMaterial=Sh()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=xh()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=yv(),this._integrationMaterial=wv());const e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;const r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/hd);for(let a=0;a<=n;a++){const o=Yr.lodToRoughness(a,n);if(a>n-xv)r.roughness.value=o,this._renderCube(t,a,this._integrationMaterial);else{const l=o>0?Math.log2(e)+.5*Math.log2(6/(cd*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(t,a,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Ev());const n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}}function vh(i,t,e){return new Rl(i,{minFilter:oi,generateMipmaps:t,type:gn,colorSpace:Vr,depthBuffer:e})}function Os(i,t,e){return new Ii({name:i,uniforms:t,vertexShader:Ot.cube_vert,fragmentShader:e,side:Ve,blending:Zi,depthTest:!1,depthWrite:!1})}function yv(){return Os("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${cd}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function wv(){return Os("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:hd}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Ev(){return Os("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${vv}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function xh(){return Os("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Sh(){return Os("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function bv(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?a(d):r(d)}function r(d){if(d&&d.isTexture){const f=d.mapping;if(f===Ea||f===ba)if(t.has(d)){const _=t.get(d).texture;return o(_,d.mapping)}else{const _=d.image;if(_&&_.height>0){const S=new Rl(_.height);return S.fromEquirectangularTexture(i,d),t.set(d,S),d.addEventListener("dispose",c),o(S.texture,d.mapping)}else return null}}return d}function a(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){const f=d.mapping,_=f===Ea||f===ba,S=f===Qi||f===Ps;if(_||S){let p=e.get(d);const m=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return n===null&&(n=new Yr(i)),p=_?n.fromEquirectangular(d,p):n.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),p.texture;if(p!==void 0)return p.texture;{const y=d.image;return _&&y&&y.height>0||S&&y&&l(y)?(n===null&&(n=new Yr(i)),p=_?n.fromEquirectangular(d):n.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function o(d,f){return f===Ea?d.mapping=Qi:f===ba&&(d.mapping=Ps),d}function l(d){let f=0;const _=6;for(let S=0;S<_;S++)d[S]!==void 0&&f++;return f===_}function c(d){const f=d.target;f.removeEventListener("dispose",c);const _=t.get(f);_!==void 0&&(t.delete(f),_.dispose())}function h(d){const f=d.target;f.removeEventListener("dispose",h);const _=e.get(f);_!==void 0&&(e.delete(f),_.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function Tv(i){const t={};function e(n){if(t[n]!==void 0)return t[n];const s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){const s=e(n);return s===null&&Ir("WebGLRenderer: "+n+" extension not supported."),s}}}function Av(i,t,e,n){const s={},r=new WeakMap,a=new FinalizationRegistry(_=>delete s[_]);function o(_){l(_.target)}function l(_){_.index!==null&&t.remove(_.index);for(const p in _.attributes)t.remove(_.attributes[p]);_.removeEventListener("dispose",o),delete s[_.id],a.unregister(_);const S=r.get(_);S&&(t.remove(S),r.delete(_)),n.releaseStatesOfGeometry(_),_.isInstancedBufferGeometry===!0&&delete _._maxInstanceCount,e.memory.geometries--}function c(_,S){return s[S.id]!==void 0||(S.addEventListener("dispose",o),s[S.id]=new WeakRef(S),a.register(S,S.id,S),e.memory.geometries++),S}function h(_){const S=_.attributes;for(const p in S)t.update(S[p],i.ARRAY_BUFFER)}function u(_){const S=_.index,p=_.attributes.position;let m=0;if(p===void 0)return;const y=S!==null?S.array.length:p.array.length/3-1,T=p.count>=65535?ed:td,M=new T(Math.ceil(y/3)*6,1),A=M.array;if(S!==null){const g=S.array;m=S.version;for(let w=0,N=0;w<y;w+=3){const C=g[w+0],D=g[w+1],B=g[w+2];A[N++]=C,A[N++]=D,A[N++]=D,A[N++]=B,A[N++]=B,A[N++]=C}}else{m=p.version;for(let g=0,w=0;g<y;g+=3){const N=g+0,C=g+1,D=g+2;A[w++]=N,A[w++]=C,A[w++]=C,A[w++]=D,A[w++]=D,A[w++]=N}}M.version=m;const E=r.get(_);E&&t.remove(E),r.set(_,M)}function d(_){const S=r.get(_);if(S){const p=_.index;p!==null&&S.version<p.version&&u(_)}else u(_);return r.get(_)}function f(){for(const _ in s){const S=s[_].deref();S!==void 0&&l(S)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function Rv(i,t,e){let n;function s(u){n=u}let r,a;function o(u){r=u.type,a=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*a),e.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*a,f),e.update(d,n,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let S=0;for(let p=0;p<f;p++)S+=d[p];e.update(S,n,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function Cv(i){const t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(e.calls++,a){case i.TRIANGLES:e.triangles+=o*(r/3);break;case i.LINES:e.lines+=o*(r/2);break;case i.LINE_STRIP:e.lines+=o*(r-1);break;case i.LINE_LOOP:e.lines+=o*r;break;case i.POINTS:e.points+=o*r;break;default:Qt("WebGLInfo: Unknown draw mode:",a);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function Lv(i,t,e){const n=new WeakMap,s=new de;function r(a,o,l){const c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,u=h!==void 0?h.length:0;let d=n.get(o);if(d===void 0||d.count!==u){let N=function(){g.dispose(),n.delete(o),o.removeEventListener("dispose",N)};d!==void 0&&d.texture.dispose();const f=o.morphAttributes.position!==void 0,_=o.morphAttributes.normal!==void 0,S=o.morphAttributes.color!==void 0,p=o.morphAttributes.position||[],m=o.morphAttributes.normal||[],y=o.morphAttributes.color||[];let T=0;f===!0&&(T=1),_===!0&&(T=2),S===!0&&(T=3);let M=o.attributes.position.count*T,A=1;M>t.maxTextureSize&&(A=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);const E=new Float32Array(M*A*4*u),g=new bl(E,M,A,u);g.type=sn,g.needsUpdate=!0;const w=T*4;for(let C=0;C<u;C++){const D=p[C],B=m[C],V=y[C],L=M*A*4*C;for(let H=0;H<D.count;H++){const $=H*w;f===!0&&(s.fromBufferAttribute(D,H),E[L+$+0]=s.x,E[L+$+1]=s.y,E[L+$+2]=s.z,E[L+$+3]=0),_===!0&&(s.fromBufferAttribute(B,H),E[L+$+4]=s.x,E[L+$+5]=s.y,E[L+$+6]=s.z,E[L+$+7]=0),S===!0&&(s.fromBufferAttribute(V,H),E[L+$+8]=s.x,E[L+$+9]=s.y,E[L+$+10]=s.z,E[L+$+11]=V.itemSize===4?s.w:1)}}d={count:u,texture:g,size:new Zt(M,A)},n.set(o,d),o.addEventListener("dispose",N)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",a.morphTexture,e);else{let f=0;for(let S=0;S<c.length;S++)f+=c[S];const _=o.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",_),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function Pv(i,t,e,n,s){let r=new WeakMap;function a(c){const h=s.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){const f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function o(){r=new WeakMap}function l(c){const h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:a,dispose:o}}const Iv={[Du]:"LINEAR_TONE_MAPPING",[Nu]:"REINHARD_TONE_MAPPING",[Uu]:"CINEON_TONE_MAPPING",[Fu]:"ACES_FILMIC_TONE_MAPPING",[ku]:"AGX_TONE_MAPPING",[Bu]:"NEUTRAL_TONE_MAPPING",[Ou]:"CUSTOM_TONE_MAPPING"};function Dv(i,t,e,n,s,r){const a=new mn(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1});let o=null,l=null,c=null;const h=new Yn;h.setAttribute("position",new qn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new qn([0,2,0,0,2,0],2));const u=new ys({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new $n(h,u),f=new R0(-1,1,1,-1,0,1);let _=null,S=null,p=!1,m,y=null,T=[],M=!1;this.setSize=function(A,E){a.setSize(A,E),o!==null&&o.setSize(A,E),l!==null&&l.setSize(A,E);for(let g=0;g<T.length;g++){const w=T[g];w.setSize&&w.setSize(A,E)}},this.setEffects=function(A){T=A,M=T.length>0&&T[0].isRenderPass===!0;const E=a.width,g=a.height;T.length>0&&o===null&&(o=new mn(E,g,{type:gn,depthBuffer:!1,stencilBuffer:!1}),l=new mn(E,g,{type:gn,depthBuffer:!1,stencilBuffer:!1}));const w=s===!0&&T.some(N=>N.needsDepthTexture===!0);w!==(a.depthTexture!==null)&&(w===!0&&c===null&&(c=new Pi(E,g),r===!0&&(c.format=li,c.type=ji)),a.dispose(),a.depthTexture=w?c:null,a.resolveDepthBuffer=w,a.storeMultisampledDepthBuffer=w);for(let N=0;N<T.length;N++){const C=T[N];C.setSize&&C.setSize(E,g),w&&C.needsDepthTexture===!0&&C.setDepthTexture&&C.setDepthTexture(c)}},this.begin=function(A,E){if(p||A.toneMapping===Vn&&T.length===0)return!1;if(y=E,E!==null){const g=E.width,w=E.height;(a.width!==g||a.height!==w)&&this.setSize(g,w)}return M===!1&&A.setRenderTarget(a),m=A.toneMapping,A.toneMapping=Vn,!0},this.hasRenderPass=function(){return M},this.end=function(A,E){A.toneMapping=m,p=!0;let g=a,w=o;for(let N=0;N<T.length;N++){const C=T[N];C.enabled!==!1&&(C.render(A,w,g,E),C.needsSwap!==!1&&(g=w,w=w===o?l:o))}if(_!==A.outputColorSpace||S!==A.toneMapping){_=A.outputColorSpace,S=A.toneMapping,u.defines={},$t.getTransfer(_)===ne&&(u.defines.SRGB_TRANSFER="");const N=Iv[S];N&&(u.defines[N]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=g.texture,A.setRenderTarget(y),A.render(d,f),y=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}const ud=new Be,dd=new Pi(1,1),fd=new id(1),pd=new bl,md=new e0,gd=new nd,Mh=[],yh=[],wh=new Float32Array(16),Eh=new Float32Array(9),bh=new Float32Array(4);function ss(i,t,e){const n=i[0];if(n<=0||n>0)return i;const s=t*e;let r=Mh[s];if(r===void 0&&(r=new Float32Array(s),Mh[s]=r),t!==0){n.toArray(r,0);for(let a=1,o=0;a!==t;++a)o+=e,i[a].toArray(r,o)}return r}function ye(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function we(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function na(i,t){let e=yh[t];e===void 0&&(e=new Int32Array(t),yh[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function Nv(i,t){const e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function Uv(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ye(e,t))return;i.uniform2fv(this.addr,t),we(e,t)}}function Fv(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(ye(e,t))return;i.uniform3fv(this.addr,t),we(e,t)}}function Ov(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ye(e,t))return;i.uniform4fv(this.addr,t),we(e,t)}}function kv(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(ye(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),we(e,t)}else{if(ye(e,n))return;bh.set(n),i.uniformMatrix2fv(this.addr,!1,bh),we(e,n)}}function Bv(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(ye(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),we(e,t)}else{if(ye(e,n))return;Eh.set(n),i.uniformMatrix3fv(this.addr,!1,Eh),we(e,n)}}function zv(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(ye(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),we(e,t)}else{if(ye(e,n))return;wh.set(n),i.uniformMatrix4fv(this.addr,!1,wh),we(e,n)}}function Gv(i,t){const e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Hv(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ye(e,t))return;i.uniform2iv(this.addr,t),we(e,t)}}function Vv(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(ye(e,t))return;i.uniform3iv(this.addr,t),we(e,t)}}function Wv(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ye(e,t))return;i.uniform4iv(this.addr,t),we(e,t)}}function Xv(i,t){const e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function qv(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ye(e,t))return;i.uniform2uiv(this.addr,t),we(e,t)}}function $v(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(ye(e,t))return;i.uniform3uiv(this.addr,t),we(e,t)}}function Yv(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ye(e,t))return;i.uniform4uiv(this.addr,t),we(e,t)}}function ia(i){return i.version===0&&(i.compareFunction=Ku,i.needsUpdate=!0),i}function Kv(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=ia(dd):r=ud,e.setTexture2D(t||r,s)}function Zv(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||md,s)}function Jv(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=ia(fd):r=gd,e.setTextureCube(t||r,s)}function Qv(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||pd,s)}function jv(i){switch(i){case 5126:return Nv;case 35664:return Uv;case 35665:return Fv;case 35666:return Ov;case 35674:return kv;case 35675:return Bv;case 35676:return zv;case 5124:case 35670:return Gv;case 35667:case 35671:return Hv;case 35668:case 35672:return Vv;case 35669:case 35673:return Wv;case 5125:return Xv;case 36294:return qv;case 36295:return $v;case 36296:return Yv;case 35678:case 36198:case 36298:case 36306:case 35682:return Kv;case 35679:case 36299:case 36307:return Zv;case 35680:case 36300:case 36308:case 36293:return Jv;case 36289:case 36303:case 36311:case 36292:return Qv}}function tx(i,t){i.uniform1fv(this.addr,t)}function ex(i,t){const e=ss(t,this.size,2);i.uniform2fv(this.addr,e)}function nx(i,t){const e=ss(t,this.size,3);i.uniform3fv(this.addr,e)}function ix(i,t){const e=ss(t,this.size,4);i.uniform4fv(this.addr,e)}function sx(i,t){const e=ss(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function rx(i,t){const e=ss(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function ax(i,t){const e=ss(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function ox(i,t){i.uniform1iv(this.addr,t)}function lx(i,t){i.uniform2iv(this.addr,t)}function cx(i,t){i.uniform3iv(this.addr,t)}function hx(i,t){i.uniform4iv(this.addr,t)}function ux(i,t){i.uniform1uiv(this.addr,t)}function dx(i,t){i.uniform2uiv(this.addr,t)}function fx(i,t){i.uniform3uiv(this.addr,t)}function px(i,t){i.uniform4uiv(this.addr,t)}function mx(i,t,e){const n=this.cache,s=t.length,r=na(e,s);ye(n,r)||(i.uniform1iv(this.addr,r),we(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=ia(dd):a=ud;for(let o=0;o!==s;++o)e.setTexture2D(t[o]||a,r[o])}function gx(i,t,e){const n=this.cache,s=t.length,r=na(e,s);ye(n,r)||(i.uniform1iv(this.addr,r),we(n,r));for(let a=0;a!==s;++a)e.setTexture3D(t[a]||md,r[a])}function _x(i,t,e){const n=this.cache,s=t.length,r=na(e,s);ye(n,r)||(i.uniform1iv(this.addr,r),we(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=ia(fd):a=gd;for(let o=0;o!==s;++o)e.setTextureCube(t[o]||a,r[o])}function vx(i,t,e){const n=this.cache,s=t.length,r=na(e,s);ye(n,r)||(i.uniform1iv(this.addr,r),we(n,r));for(let a=0;a!==s;++a)e.setTexture2DArray(t[a]||pd,r[a])}function xx(i){switch(i){case 5126:return tx;case 35664:return ex;case 35665:return nx;case 35666:return ix;case 35674:return sx;case 35675:return rx;case 35676:return ax;case 5124:case 35670:return ox;case 35667:case 35671:return lx;case 35668:case 35672:return cx;case 35669:case 35673:return hx;case 5125:return ux;case 36294:return dx;case 36295:return fx;case 36296:return px;case 35678:case 36198:case 36298:case 36306:case 35682:return mx;case 35679:case 36299:case 36307:return gx;case 35680:case 36300:case 36308:case 36293:return _x;case 36289:case 36303:case 36311:case 36292:return vx}}class Sx{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=jv(e.type)}}class Mx{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=xx(e.type)}}class yx{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){const s=this.seq;for(let r=0,a=s.length;r!==a;++r){const o=s[r];o.setValue(t,e[o.id],n)}}}const Za=/(\w+)(\])?(\[|\.)?/g;function Th(i,t){i.seq.push(t),i.map[t.id]=t}function wx(i,t,e){const n=i.name,s=n.length;for(Za.lastIndex=0;;){const r=Za.exec(n),a=Za.lastIndex;let o=r[1];const l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){Th(e,c===void 0?new Sx(o,i,t):new Mx(o,i,t));break}else{let u=e.map[o];u===void 0&&(u=new yx(o),Th(e,u)),e=u}}}class Nr{constructor(t,e){this.seq=[],this.map={};const n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){const o=t.getActiveUniform(e,a),l=t.getUniformLocation(e,o.name);wx(o,l,this)}const s=[],r=[];for(const a of this.seq)a.type===t.SAMPLER_2D_SHADOW||a.type===t.SAMPLER_CUBE_SHADOW||a.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){const r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){const s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,a=e.length;r!==a;++r){const o=e[r],l=n[o.id];l.needsUpdate!==!1&&o.setValue(t,l.value,s)}}static seqWithValue(t,e){const n=[];for(let s=0,r=t.length;s!==r;++s){const a=t[s];a.id in e&&n.push(a)}return n}}function Ah(i,t,e){const n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}const Ex=37297;let bx=0;function Tx(i,t){const e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let a=s;a<r;a++){const o=a+1;n.push(`${o===t?">":" "} ${o}: ${e[a]}`)}return n.join(`
`)}const Rh=new Pt;function Ax(i){$t._getMatrix(Rh,$t.workingColorSpace,i);const t=`mat3( ${Rh.elements.map(e=>e.toFixed(4))} )`;switch($t.getTransfer(i)){case Wr:return[t,"LinearTransferOETF"];case ne:return[t,"sRGBTransferOETF"];default:return Ct("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Ch(i,t,e){const n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";const a=/ERROR: 0:(\d+)/.exec(r);if(a){const o=parseInt(a[1]);return e.toUpperCase()+`

`+r+`

`+Tx(i.getShaderSource(t),o)}else return r}function Rx(i,t){const e=Ax(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}const Cx={[Du]:"Linear",[Nu]:"Reinhard",[Uu]:"Cineon",[Fu]:"ACESFilmic",[ku]:"AgX",[Bu]:"Neutral",[Ou]:"Custom"};function Lx(i,t){const e=Cx[t];return e===void 0?(Ct("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}const gr=new O;function Px(){$t.getLuminanceCoefficients(gr);const i=gr.x.toFixed(4),t=gr.y.toFixed(4),e=gr.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Ix(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ws).join(`
`)}function Dx(i){const t=[];for(const e in i){const n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function Nx(i,t){const e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){const r=i.getActiveAttrib(t,s),a=r.name;let o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),e[a]={type:r.type,location:i.getAttribLocation(t,a),locationSize:o}}return e}function ws(i){return i!==""}function Lh(i,t){const e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Ph(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}const Ux=/^[ \t]*#include +<([\w\d./]+)>/gm;function tl(i){return i.replace(Ux,Fx)}function Fx(i,t){const e=Ot[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return tl(e)}const Ox=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ih(i){return i.replace(Ox,kx)}function kx(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Dh(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}const Bx={[Ar]:"SHADOWMAP_TYPE_PCF",[Ms]:"SHADOWMAP_TYPE_VSM"};function zx(i){return Bx[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}const Gx={[Ps]:"ENVMAP_MODE_REFRACTION"};function Hx(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Gx[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}const Vx={[Iu]:"ENVMAP_BLENDING_MULTIPLY",[Lm]:"ENVMAP_BLENDING_MIX",[Pm]:"ENVMAP_BLENDING_ADD"};function Wx(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":Vx[i.combine]||"ENVMAP_BLENDING_NONE"}function Xx(i,t,e,n){const s=i.getContext(),r=e.defines;let a=e.vertexShader,o=e.fragmentShader;const l=zx(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Hx(e),u=Wx(e),d=Ix(e),f=Dx(r),_=s.createProgram();let S,p,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(S=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(ws).join(`
`),S.length>0&&(S+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(ws).join(`
`),p.length>0&&(p+=`
`)):(S=[Dh(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ws).join(`
`),p=[Dh(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Vn?"#define TONE_MAPPING":"",e.toneMapping!==Vn?Ot.tonemapping_pars_fragment:"",e.toneMapping!==Vn?Lx("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Ot.colorspace_pars_fragment,Rx("linearToOutputTexel",e.outputColorSpace),Px(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(ws).join(`
`)),a=tl(a),a=Lh(a,e),a=Ph(a,e),o=tl(o),o=Lh(o,e),o=Ph(o,e),a=Ih(a),o=Ih(o),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,S=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+S,p=["#define varying in",e.glslVersion===Ki?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Ki?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);const y=m+S+a,T=m+p+o,M=Ah(s,s.VERTEX_SHADER,y),A=Ah(s,s.FRAGMENT_SHADER,T);s.attachShader(_,M),s.attachShader(_,A),e.index0AttributeName!==void 0?s.bindAttribLocation(_,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function E(C){if(i.debug.checkShaderErrors){const D=s.getProgramInfoLog(_)||"",B=s.getShaderInfoLog(M)||"",V=s.getShaderInfoLog(A)||"",L=D.trim(),H=B.trim(),$=V.trim();let G=!0,tt=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(G=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,_,M,A);else{const X=Ch(s,M,"vertex"),Q=Ch(s,A,"fragment");Qt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+L+`
`+X+`
`+Q)}else L!==""?Ct("WebGLProgram: Program Info Log:",L):(H===""||$==="")&&(tt=!1);tt&&(C.diagnostics={runnable:G,programLog:L,vertexShader:{log:H,prefix:S},fragmentShader:{log:$,prefix:p}})}s.deleteShader(M),s.deleteShader(A),g=new Nr(s,_),w=Nx(s,_)}let g;this.getUniforms=function(){return g===void 0&&E(this),g};let w;this.getAttributes=function(){return w===void 0&&E(this),w};let N=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(_,Ex)),N},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=bx++,this.cacheKey=t,this.usedTimes=1,this.program=_,this.vertexShader=M,this.fragmentShader=A,this}let qx=0;class $x{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){const s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){const e=this.materialCache.get(t);for(const n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){const e=this.materialCache;let n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){const e=this.shaderCache;let n=e.get(t);return n===void 0&&(n=new Yx(t),e.set(t,n)),n}}class Yx{constructor(t){this.id=qx++,this.code=t,this.usedTimes=0}}function Kx(i){return i===ui||i===Gr||i===Hr}function Zx(i,t,e,n,s,r){const a=new Ju,o=new $x,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(g){return l.add(g),g===0?"uv":`uv${g}`}function _(g,w,N,C,D,B){const V=C.fog,L=D.geometry,H=g.isMeshStandardMaterial||g.isMeshLambertMaterial||g.isMeshPhongMaterial?C.environment:null,$=g.isMeshStandardMaterial||g.isMeshLambertMaterial&&!g.envMap||g.isMeshPhongMaterial&&!g.envMap,G=t.get(g.envMap||H,$),tt=d[g.type];let X=n.precision;g.precision!==null&&(X=n.getMaxPrecision(g.precision),X!==g.precision&&Ct("WebGLProgram.getParameters:",g.precision,"not supported, using",X,"instead."));const Q=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,j=Q!==void 0?Q.length:0;let yt=0;L.morphAttributes.position!==void 0&&(yt=1),L.morphAttributes.normal!==void 0&&(yt=2),L.morphAttributes.color!==void 0&&(yt=3);let It,K,pt,vt;if(tt){const dt=wn[tt];It=dt.vertexShader,K=dt.fragmentShader}else{It=g.vertexShader,K=g.fragmentShader;const dt=o.getVertexShaderStage(g),ee=o.getFragmentShaderStage(g);o.update(g,dt,ee),pt=dt.id,vt=ee.id}const Tt=i.getRenderTarget(),mt=i.state.buffers.depth.getReversed(),Nt=D.isInstancedMesh===!0,me=D.isBatchedMesh===!0,Rt=!!g.map,te=!!g.matcap,ie=!!G,Gt=ie&&G.isPMREMTexture===!0,Le=!!g.aoMap,Se=!!g.lightMap,Ge=!!g.bumpMap&&g.wireframe===!1,he=!!g.normalMap,_n=!!g.displacementMap,Ee=!!g.emissiveMap,Ke=!!g.metalnessMap,Ze=!!g.roughnessMap,Je=g.anisotropy>0,I=g.clearcoat>0,Qe=g.diffuseRoughness>0,oe=g.dispersion>0,le=g.retroreflectivity>0,ut=g.iridescence>0,Me=g.sheen>0,At=g.transmission>0,Lt=Je&&!!g.anisotropyMap,b=I&&!!g.clearcoatMap,v=I&&!!g.clearcoatNormalMap,F=I&&!!g.clearcoatRoughnessMap,et=Qe&&!!g.diffuseRoughnessMap,J=ut&&!!g.iridescenceMap,st=ut&&!!g.iridescenceThicknessMap,ct=Me&&!!g.sheenColorMap,q=Me&&!!g.sheenRoughnessMap,Y=!!g.specularMap,at=!!g.specularColorMap,R=!!g.specularIntensityMap,Z=At&&!!g.transmissionMap,W=At&&!!g.thicknessMap,ot=!!g.gradientMap,it=!!g.alphaMap,rt=g.alphaTest>0,Et=!!g.alphaHash,Ft=!!g.extensions;let nt=Vn;g.toneMapped&&(Tt===null||Tt.isXRRenderTarget===!0)&&(nt=i.toneMapping);const bt=Gt?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Ut={shaderID:tt,shaderType:g.type,shaderName:g.name,vertexShader:It,fragmentShader:K,defines:g.defines,customVertexShaderID:pt,customFragmentShaderID:vt,isRawShaderMaterial:g.isRawShaderMaterial===!0,glslVersion:g.glslVersion,precision:X,batching:me,batchingColor:me&&D._colorsTexture!==null,instancing:Nt,instancingColor:Nt&&D.instanceColor!==null,instancingMorph:Nt&&D.morphTexture!==null,outputColorSpace:Tt===null?i.outputColorSpace:Tt.isXRRenderTarget===!0?Tt.texture.colorSpace:$t.workingColorSpace,alphaToCoverage:!!g.alphaToCoverage,map:Rt,matcap:te,envMap:ie,envMapMode:ie&&G.mapping,envMapPMREM:Gt,envMapMaxLod:Gt?bt.length-1:null,envMapSize:Gt?bt[0].width:null,aoMap:Le,lightMap:Se,bumpMap:Ge,normalMap:he,displacementMap:_n,emissiveMap:Ee,normalMapObjectSpace:he&&g.normalMapType===Nm,normalMapTangentSpace:he&&g.normalMapType===Kc,packedNormalMap:he&&g.normalMapType===Kc&&Kx(g.normalMap.format),metalnessMap:Ke,roughnessMap:Ze,anisotropy:Je,anisotropyMap:Lt,clearcoat:I,clearcoatMap:b,clearcoatNormalMap:v,clearcoatRoughnessMap:F,diffuseRoughness:Qe,diffuseRoughnessMap:et,dispersion:oe,retroreflection:le,iridescence:ut,iridescenceMap:J,iridescenceThicknessMap:st,sheen:Me,sheenColorMap:ct,sheenRoughnessMap:q,specularMap:Y,specularColorMap:at,specularIntensityMap:R,transmission:At,transmissionMap:Z,thicknessMap:W,gradientMap:ot,opaque:g.transparent===!1&&g.blending===As&&g.alphaToCoverage===!1,alphaMap:it,alphaTest:rt,alphaHash:Et,combine:g.combine,mapUv:Rt&&f(g.map.channel),aoMapUv:Le&&f(g.aoMap.channel),lightMapUv:Se&&f(g.lightMap.channel),bumpMapUv:Ge&&f(g.bumpMap.channel),normalMapUv:he&&f(g.normalMap.channel),displacementMapUv:_n&&f(g.displacementMap.channel),emissiveMapUv:Ee&&f(g.emissiveMap.channel),metalnessMapUv:Ke&&f(g.metalnessMap.channel),roughnessMapUv:Ze&&f(g.roughnessMap.channel),anisotropyMapUv:Lt&&f(g.anisotropyMap.channel),clearcoatMapUv:b&&f(g.clearcoatMap.channel),clearcoatNormalMapUv:v&&f(g.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:F&&f(g.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:et&&f(g.diffuseRoughnessMap.channel),iridescenceMapUv:J&&f(g.iridescenceMap.channel),iridescenceThicknessMapUv:st&&f(g.iridescenceThicknessMap.channel),sheenColorMapUv:ct&&f(g.sheenColorMap.channel),sheenRoughnessMapUv:q&&f(g.sheenRoughnessMap.channel),specularMapUv:Y&&f(g.specularMap.channel),specularColorMapUv:at&&f(g.specularColorMap.channel),specularIntensityMapUv:R&&f(g.specularIntensityMap.channel),transmissionMapUv:Z&&f(g.transmissionMap.channel),thicknessMapUv:W&&f(g.thicknessMap.channel),alphaMapUv:it&&f(g.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(he||Je),vertexNormals:!!L.attributes.normal,vertexColors:g.vertexColors,vertexAlphas:g.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!L.attributes.uv&&(Rt||it),fog:!!V,useFog:g.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:g.wireframe===!1&&(g.flatShading===!0||L.attributes.normal===void 0&&he===!1&&(g.isMeshLambertMaterial||g.isMeshPhongMaterial||g.isMeshStandardMaterial||g.isMeshPhysicalMaterial)),sizeAttenuation:g.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:mt,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:j,morphTextureStride:yt,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:B.filter(dt=>dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:g.dithering,shadowMapEnabled:i.shadowMap.enabled&&N.length>0,shadowMapType:i.shadowMap.type,toneMapping:nt,decodeVideoTexture:Rt&&g.map.isVideoTexture===!0&&$t.getTransfer(g.map.colorSpace)===ne,decodeVideoTextureEmissive:Ee&&g.emissiveMap.isVideoTexture===!0&&$t.getTransfer(g.emissiveMap.colorSpace)===ne,premultipliedAlpha:g.premultipliedAlpha,doubleSided:g.side===bn,flipSided:g.side===Ve,useDepthPacking:g.depthPacking>=0,depthPacking:g.depthPacking||0,index0AttributeName:g.index0AttributeName,extensionClipCullDistance:Ft&&g.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ft&&g.extensions.multiDraw===!0||me)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:g.customProgramCacheKey()};return Ut.vertexUv1s=l.has(1),Ut.vertexUv2s=l.has(2),Ut.vertexUv3s=l.has(3),l.clear(),Ut}function S(g){const w=[];if(g.shaderID?w.push(g.shaderID):(w.push(g.customVertexShaderID),w.push(g.customFragmentShaderID)),g.defines!==void 0)for(const N in g.defines)w.push(N),w.push(g.defines[N]);return g.isRawShaderMaterial===!1&&(p(w,g),m(w,g),w.push(i.outputColorSpace)),w.push(g.customProgramCacheKey),w.join()}function p(g,w){g.push(w.precision),g.push(w.outputColorSpace),g.push(w.envMapMode),g.push(w.envMapPMREM),g.push(w.envMapMaxLod),g.push(w.envMapSize),g.push(w.mapUv),g.push(w.alphaMapUv),g.push(w.lightMapUv),g.push(w.aoMapUv),g.push(w.bumpMapUv),g.push(w.normalMapUv),g.push(w.displacementMapUv),g.push(w.emissiveMapUv),g.push(w.metalnessMapUv),g.push(w.roughnessMapUv),g.push(w.anisotropyMapUv),g.push(w.clearcoatMapUv),g.push(w.clearcoatNormalMapUv),g.push(w.clearcoatRoughnessMapUv),g.push(w.diffuseRoughnessMapUv),g.push(w.iridescenceMapUv),g.push(w.iridescenceThicknessMapUv),g.push(w.sheenColorMapUv),g.push(w.sheenRoughnessMapUv),g.push(w.specularMapUv),g.push(w.specularColorMapUv),g.push(w.specularIntensityMapUv),g.push(w.transmissionMapUv),g.push(w.thicknessMapUv),g.push(w.combine),g.push(w.fogExp2),g.push(w.sizeAttenuation),g.push(w.morphTargetsCount),g.push(w.numSunLights),g.push(w.numDirLights),g.push(w.numPointLights),g.push(w.numSpotLights),g.push(w.numSpotLightMaps),g.push(w.numHemiLights),g.push(w.numRectAreaLights),g.push(w.numSunLightShadows),g.push(w.numDirLightShadows),g.push(w.numPointLightShadows),g.push(w.numSpotLightShadows),g.push(w.numSpotLightShadowsWithMaps),g.push(w.numLightProbes),g.push(w.numLightProbeGrids),g.push(w.shadowMapType),g.push(w.toneMapping),g.push(w.numClippingPlanes),g.push(w.numClipIntersection),g.push(w.depthPacking)}function m(g,w){a.disableAll(),w.instancing&&a.enable(0),w.instancingColor&&a.enable(1),w.instancingMorph&&a.enable(2),w.matcap&&a.enable(3),w.envMap&&a.enable(4),w.normalMapObjectSpace&&a.enable(5),w.normalMapTangentSpace&&a.enable(6),w.clearcoat&&a.enable(7),w.iridescence&&a.enable(8),w.alphaTest&&a.enable(9),w.vertexColors&&a.enable(10),w.vertexAlphas&&a.enable(11),w.vertexUv1s&&a.enable(12),w.vertexUv2s&&a.enable(13),w.vertexUv3s&&a.enable(14),w.vertexTangents&&a.enable(15),w.anisotropy&&a.enable(16),w.alphaHash&&a.enable(17),w.batching&&a.enable(18),w.dispersion&&a.enable(19),w.retroreflection&&a.enable(24),w.diffuseRoughness&&a.enable(25),w.batchingColor&&a.enable(20),w.gradientMap&&a.enable(21),w.packedNormalMap&&a.enable(22),w.vertexNormals&&a.enable(23),g.push(a.mask),a.disableAll(),w.fog&&a.enable(0),w.useFog&&a.enable(1),w.flatShading&&a.enable(2),w.logarithmicDepthBuffer&&a.enable(3),w.reversedDepthBuffer&&a.enable(4),w.skinning&&a.enable(5),w.morphTargets&&a.enable(6),w.morphNormals&&a.enable(7),w.morphColors&&a.enable(8),w.premultipliedAlpha&&a.enable(9),w.shadowMapEnabled&&a.enable(10),w.doubleSided&&a.enable(11),w.flipSided&&a.enable(12),w.useDepthPacking&&a.enable(13),w.dithering&&a.enable(14),w.transmission&&a.enable(15),w.sheen&&a.enable(16),w.opaque&&a.enable(17),w.pointsUvs&&a.enable(18),w.decodeVideoTexture&&a.enable(19),w.decodeVideoTextureEmissive&&a.enable(20),w.alphaToCoverage&&a.enable(21),w.numLightProbeGrids>0&&a.enable(22),w.hasPositionAttribute&&a.enable(23),g.push(a.mask)}function y(g){const w=d[g.type];let N;if(w){const C=wn[w];N=w0.clone(C.uniforms)}else N=g.uniforms;return N}function T(g,w){let N=h.get(w);return N!==void 0?++N.usedTimes:(N=new Xx(i,w,g,s),c.push(N),h.set(w,N)),N}function M(g){if(--g.usedTimes===0){const w=c.indexOf(g);c[w]=c[c.length-1],c.pop(),h.delete(g.cacheKey),g.destroy()}}function A(g){o.remove(g)}function E(){o.dispose()}return{getParameters:_,getProgramCacheKey:S,getUniforms:y,acquireProgram:T,releaseProgram:M,releaseShaderCache:A,programs:c,dispose:E}}function Jx(){let i=new WeakMap;function t(a){return i.has(a)}function e(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,l){i.get(a)[o]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function Qx(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function Nh(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Uh(){const i=[];let t=0;const e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function a(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function o(d,f,_,S,p,m){let y=i[t];return y===void 0?(y={id:d.id,object:d,geometry:f,material:_,materialVariant:a(d),groupOrder:S,renderOrder:d.renderOrder,z:p,group:m},i[t]=y):(y.id=d.id,y.object=d,y.geometry=f,y.material=_,y.materialVariant=a(d),y.groupOrder=S,y.renderOrder=d.renderOrder,y.z=p,y.group=m),t++,y}function l(d,f,_,S,p,m,y){y.reversedDepth===!0&&(p=-p);const T=o(d,f,_,S,p,m);_.transmission>0?n.push(T):_.transparent===!0?s.push(T):e.push(T)}function c(d,f,_,S,p,m){const y=o(d,f,_,S,p,m);_.transmission>0?n.unshift(y):_.transparent===!0?s.unshift(y):e.unshift(y)}function h(d,f){e.length>1&&e.sort(d||Qx),n.length>1&&n.sort(f||Nh),s.length>1&&s.sort(f||Nh)}function u(){for(let d=t,f=i.length;d<f;d++){const _=i[d];if(_.id===null)break;_.id=null,_.object=null,_.geometry=null,_.material=null,_.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function jx(){let i=new WeakMap;function t(n,s){const r=i.get(n);let a;return r===void 0?(a=new Uh,i.set(n,[a])):s>=r.length?(a=new Uh,r.push(a)):a=r[s],a}function e(){i=new WeakMap}return{get:t,dispose:e}}function tS(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new O,color:new Yt};break;case"SpotLight":e={position:new O,direction:new O,color:new Yt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new O,color:new Yt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new O,skyColor:new Yt,groundColor:new Yt};break;case"RectAreaLight":e={color:new Yt,position:new O,halfWidth:new O,halfHeight:new O};break}return i[t.id]=e,e}}}function eS(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}let nS=0;function iS(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function sS(i){const t=new tS,e=eS(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new O);const s=new O,r=new jt,a=new jt;function o(c){let h=0,u=0,d=0;for(let B=0;B<9;B++)n.probe[B].set(0,0,0);let f=0,_=0,S=0,p=0,m=0,y=0,T=0,M=0,A=0,E=0,g=0,w=0,N=0,C=0;c.sort(iS);for(let B=0,V=c.length;B<V;B++){const L=c[B],H=L.color,$=L.intensity,G=L.distance;let tt=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===ui?tt=L.shadow.map.texture:tt=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)h+=H.r*$,u+=H.g*$,d+=H.b*$;else if(L.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(L.sh.coefficients[X],$);C++}else if(L.isSunLight){const X=t.get(L);if(X.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){const Q=L.shadow,j=e.get(L);j.shadowIntensity=Q.intensity,j.shadowBias=Q.bias,j.shadowNormalBias=Q.normalBias,j.shadowRadius=Q.radius,j.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[_]=j,n.sunShadowMap[_]=tt;const yt=Q.getViewportCount();for(let It=0;It<yt;It++)n.sunShadowMatrix[S+It]=Q.getMatrix(It),n.sunShadowCascade[S+It]=Q._cascadeData[It];S+=yt,_++}n.sun[f]=X,f++}else if(L.isDirectionalLight){const X=t.get(L);if(X.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){const Q=L.shadow,j=e.get(L);j.shadowIntensity=Q.intensity,j.shadowBias=Q.bias,j.shadowNormalBias=Q.normalBias,j.shadowRadius=Q.radius,j.shadowMapSize=Q.mapSize,n.directionalShadow[p]=j,n.directionalShadowMap[p]=tt,n.directionalShadowMatrix[p]=L.shadow.matrix,A++}n.directional[p]=X,p++}else if(L.isSpotLight){const X=t.get(L);X.position.setFromMatrixPosition(L.matrixWorld),X.color.copy(H).multiplyScalar($),X.distance=G,X.coneCos=Math.cos(L.angle),X.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),X.decay=L.decay,n.spot[y]=X;const Q=L.shadow;if(L.map&&(n.spotLightMap[w]=L.map,w++,Q.updateMatrices(L),L.castShadow&&N++),n.spotLightMatrix[y]=Q.matrix,L.castShadow){const j=e.get(L);j.shadowIntensity=Q.intensity,j.shadowBias=Q.bias,j.shadowNormalBias=Q.normalBias,j.shadowRadius=Q.radius,j.shadowMapSize=Q.mapSize,n.spotShadow[y]=j,n.spotShadowMap[y]=tt,g++}y++}else if(L.isRectAreaLight){const X=t.get(L);X.color.copy(H).multiplyScalar($),X.halfWidth.set(L.width*.5,0,0),X.halfHeight.set(0,L.height*.5,0),n.rectArea[T]=X,T++}else if(L.isPointLight){const X=t.get(L);if(X.color.copy(L.color).multiplyScalar(L.intensity),X.distance=L.distance,X.decay=L.decay,L.castShadow){const Q=L.shadow,j=e.get(L);j.shadowIntensity=Q.intensity,j.shadowBias=Q.bias,j.shadowNormalBias=Q.normalBias,j.shadowRadius=Q.radius,j.shadowMapSize=Q.mapSize,j.shadowCameraNear=Q.camera.near,j.shadowCameraFar=Q.camera.far,n.pointShadow[m]=j,n.pointShadowMap[m]=tt,n.pointShadowMatrix[m]=L.shadow.matrix,E++}n.point[m]=X,m++}else if(L.isHemisphereLight){const X=t.get(L);X.skyColor.copy(L.color).multiplyScalar($),X.groundColor.copy(L.groundColor).multiplyScalar($),n.hemi[M]=X,M++}}T>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ft.LTC_FLOAT_1,n.rectAreaLTC2=ft.LTC_FLOAT_2):(n.rectAreaLTC1=ft.LTC_HALF_1,n.rectAreaLTC2=ft.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;const D=n.hash;(D.sunLength!==f||D.directionalLength!==p||D.pointLength!==m||D.spotLength!==y||D.rectAreaLength!==T||D.hemiLength!==M||D.numSunShadows!==_||D.numDirectionalShadows!==A||D.numPointShadows!==E||D.numSpotShadows!==g||D.numSpotMaps!==w||D.numLightProbes!==C)&&(n.sun.length=f,n.directional.length=p,n.spot.length=y,n.rectArea.length=T,n.point.length=m,n.hemi.length=M,n.sunShadow.length=_,n.sunShadowMap.length=_,n.sunShadowMatrix.length=S,n.sunShadowCascade.length=S,n.directionalShadow.length=A,n.directionalShadowMap.length=A,n.directionalShadowMatrix.length=A,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=g,n.spotShadowMap.length=g,n.spotLightMatrix.length=g+w-N,n.spotLightMap.length=w,n.numSpotLightShadowsWithMaps=N,n.numLightProbes=C,D.sunLength=f,D.directionalLength=p,D.pointLength=m,D.spotLength=y,D.rectAreaLength=T,D.hemiLength=M,D.numSunShadows=_,D.numDirectionalShadows=A,D.numPointShadows=E,D.numSpotShadows=g,D.numSpotMaps=w,D.numLightProbes=C,n.version=nS++)}function l(c,h){let u=0,d=0,f=0,_=0,S=0,p=0;const m=h.matrixWorldInverse;for(let y=0,T=c.length;y<T;y++){const M=c[y];if(M.isSunLight){const A=n.sun[u];A.direction.setFromMatrixPosition(M.matrixWorld),A.direction.transformDirection(m),u++}else if(M.isDirectionalLight){const A=n.directional[d];A.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),d++}else if(M.isSpotLight){const A=n.spot[_];A.position.setFromMatrixPosition(M.matrixWorld),A.position.applyMatrix4(m),A.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),_++}else if(M.isRectAreaLight){const A=n.rectArea[S];A.position.setFromMatrixPosition(M.matrixWorld),A.position.applyMatrix4(m),a.identity(),r.copy(M.matrixWorld),r.premultiply(m),a.extractRotation(r),A.halfWidth.set(M.width*.5,0,0),A.halfHeight.set(0,M.height*.5,0),A.halfWidth.applyMatrix4(a),A.halfHeight.applyMatrix4(a),S++}else if(M.isPointLight){const A=n.point[f];A.position.setFromMatrixPosition(M.matrixWorld),A.position.applyMatrix4(m),f++}else if(M.isHemisphereLight){const A=n.hemi[p];A.direction.setFromMatrixPosition(M.matrixWorld),A.direction.transformDirection(m),p++}}}return{setup:o,setupView:l,state:n}}function Fh(i){const t=new sS(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function a(u){u.isLightProbeGrid?s.push(u):e.push(u)}function o(u){n.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}const h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function rS(i){let t=new WeakMap;function e(s,r=0){const a=t.get(s);let o;return a===void 0?(o=new Fh(i),t.set(s,[o])):r>=a.length?(o=new Fh(i),a.push(o)):o=a[r],o}function n(){t=new WeakMap}return{get:e,dispose:n}}const aS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,oS=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,lS=[new O(1,0,0),new O(-1,0,0),new O(0,1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1)],cS=[new O(0,-1,0),new O(0,-1,0),new O(0,0,1),new O(0,0,-1),new O(0,-1,0),new O(0,-1,0)],Oh=new jt,ds=new O,Ja=new O;function hS(i,t,e){let n=new $r;const s=new Zt,r=new Zt,a=new de,o=new T0,l=new A0,c={},h=e.maxTextureSize,u={[ci]:Ve,[Ve]:ci,[bn]:bn},d=new Ii({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Zt},radius:{value:4}},vertexShader:aS,fragmentShader:oS}),f=d.clone();f.defines.HORIZONTAL_PASS=1;const _=new Yn;_.setAttribute("position",new Xn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const S=new $n(_,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ar;let m=this.type;this.render=function(E,g,w){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;this.type===um&&(Ct("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ar);const N=i.getRenderTarget(),C=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),B=i.state;B.setBlending(Zi),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);const V=m!==this.type;V&&g.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(H=>H.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,H=E.length;L<H;L++){const $=E[L],G=$.shadow;if(G===void 0){Ct("WebGLShadowMap:",$,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);const tt=G.getFrameExtents();s.multiply(tt),r.copy(G.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/tt.x),s.x=r.x*tt.x,G.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/tt.y),s.y=r.y*tt.y,G.mapSize.y=r.y));const X=i.state.buffers.depth.getReversed();if(G.camera._reversedDepth=X,G.map===null||V===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Ms){if($.isPointLight){Ct("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new mn(s.x,s.y,{format:ui,type:gn,minFilter:Fe,magFilter:Fe,generateMipmaps:!1}),G.map.texture.name=$.name+".shadowMap",G.map.depthTexture=new Pi(s.x,s.y,sn),G.map.depthTexture.name=$.name+".shadowMapDepth",G.map.depthTexture.format=hi,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=xe,G.map.depthTexture.magFilter=xe}else $.isPointLight?(G.map=new Rl(s.x),G.map.depthTexture=new id(s.x,an)):(G.map=new mn(s.x,s.y),G.map.depthTexture=new Pi(s.x,s.y,an)),G.map.depthTexture.name=$.name+".shadowMap",G.map.depthTexture.format=hi,this.type===Ar?(G.map.depthTexture.compareFunction=X?Yu:yl,G.map.depthTexture.minFilter=Fe,G.map.depthTexture.magFilter=Fe):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=xe,G.map.depthTexture.magFilter=xe);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);const Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();$.isPointLight!==!0&&G.updateMatrices($,w);const j=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:w.layers;for(let yt=0;yt<Q;yt++){const It=G.getCamera(yt);if($.isPointLight){const K=G.camera,pt=G.matrix,vt=$.distance||K.far;vt!==K.far&&(K.far=vt,K.updateProjectionMatrix()),ds.setFromMatrixPosition($.matrixWorld),K.position.copy(ds),Ja.copy(K.position),Ja.add(lS[yt]),K.up.copy(cS[yt]),K.lookAt(Ja),K.updateMatrixWorld(),pt.makeTranslation(-ds.x,-ds.y,-ds.z),Oh.multiplyMatrices(K.projectionMatrix,K.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Oh,K.coordinateSystem,K.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)i.setRenderTarget(G.map,yt),i.clear();else{yt===0&&(i.setRenderTarget(G.map),i.clear());const K=G.getViewport(yt);a.set(r.x*K.x,r.y*K.y,r.x*K.z,r.y*K.w),B.viewport(a)}n=G.getFrustum(yt),M(g,w,It,$,j,this.type)}G.isPointLightShadow!==!0&&this.type===Ms&&y(G,w),G.needsUpdate=!1}m=this.type,p.needsUpdate=!1,i.setRenderTarget(N,C,D)};function y(E,g){const w=t.update(S);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new mn(s.x,s.y,{format:ui,type:gn}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(g,null,w,d,S,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(g,null,w,f,S,null)}function T(E,g,w,N){let C=null;const D=w.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)C=D;else if(C=w.isPointLight===!0?l:o,i.localClippingEnabled&&g.clipShadows===!0&&Array.isArray(g.clippingPlanes)&&g.clippingPlanes.length!==0||g.displacementMap&&g.displacementScale!==0||g.alphaMap&&g.alphaTest>0||g.map&&g.alphaTest>0||g.alphaToCoverage===!0){const B=C.uuid,V=g.uuid;let L=c[B];L===void 0&&(L={},c[B]=L);let H=L[V];H===void 0&&(H=C.clone(),L[V]=H,g.addEventListener("dispose",A)),C=H}if(C.visible=g.visible,C.wireframe=g.wireframe,N===Ms?C.side=g.shadowSide!==null?g.shadowSide:g.side:C.side=g.shadowSide!==null?g.shadowSide:u[g.side],C.alphaMap=g.alphaMap,C.alphaTest=g.alphaToCoverage===!0?.5:g.alphaTest,C.map=g.map,C.clipShadows=g.clipShadows,C.clippingPlanes=g.clippingPlanes,C.clipIntersection=g.clipIntersection,C.displacementMap=g.displacementMap,C.displacementScale=g.displacementScale,C.displacementBias=g.displacementBias,C.wireframeLinewidth=g.wireframeLinewidth,C.linewidth=g.linewidth,w.isPointLight===!0&&C.isMeshDistanceMaterial===!0){const B=i.properties.get(C);B.light=w}return C}function M(E,g,w,N,C,D){if(E.visible===!1)return;if(E.layers.test(C)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===Ms)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,E.matrixWorld);const L=t.update(E),H=E.material;if(Array.isArray(H)){const $=L.groups;for(let G=0,tt=$.length;G<tt;G++){const X=$[G],Q=H[X.materialIndex];if(Q&&Q.visible){const j=T(E,Q,N,D);E.onBeforeShadow(i,E,g,w,L,j,X),i.renderBufferDirect(w,null,L,j,E,X),E.onAfterShadow(i,E,g,w,L,j,X)}}}else if(H.visible){const $=T(E,H,N,D);E.onBeforeShadow(i,E,g,w,L,$,null),i.renderBufferDirect(w,null,L,$,E,null),E.onAfterShadow(i,E,g,w,L,$,null)}}const V=E.children;for(let L=0,H=V.length;L<H;L++)M(V[L],g,w,N,C,D)}function A(E){E.target.removeEventListener("dispose",A);for(const w in c){const N=c[w],C=E.target.uuid;C in N&&(N[C].dispose(),delete N[C])}}}function uS(i,t){function e(){let R=!1;const Z=new de;let W=null;const ot=new de(0,0,0,0);return{setMask:function(it){W!==it&&!R&&(i.colorMask(it,it,it,it),W=it)},setLocked:function(it){R=it},setClear:function(it,rt,Et,Ft,nt){nt===!0&&(it*=Ft,rt*=Ft,Et*=Ft),Z.set(it,rt,Et,Ft),ot.equals(Z)===!1&&(i.clearColor(it,rt,Et,Ft),ot.copy(Z))},reset:function(){R=!1,W=null,ot.set(-1,0,0,0)}}}function n(){let R=!1,Z=!1,W=null,ot=null,it=null;return{setReversed:function(rt){if(Z!==rt){const Et=t.get("EXT_clip_control");rt?Et.clipControlEXT(Et.LOWER_LEFT_EXT,Et.ZERO_TO_ONE_EXT):Et.clipControlEXT(Et.LOWER_LEFT_EXT,Et.NEGATIVE_ONE_TO_ONE_EXT),Z=rt;const Ft=it;it=null,this.setClear(Ft)}},getReversed:function(){return Z},setTest:function(rt){rt?mt(i.DEPTH_TEST):Nt(i.DEPTH_TEST)},setMask:function(rt){W!==rt&&!R&&(i.depthMask(rt),W=rt)},setFunc:function(rt){if(Z&&(rt=Xm[rt]),ot!==rt){switch(rt){case po:i.depthFunc(i.NEVER);break;case mo:i.depthFunc(i.ALWAYS);break;case go:i.depthFunc(i.LESS);break;case Ls:i.depthFunc(i.LEQUAL);break;case _o:i.depthFunc(i.EQUAL);break;case vo:i.depthFunc(i.GEQUAL);break;case xo:i.depthFunc(i.GREATER);break;case So:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ot=rt}},setLocked:function(rt){R=rt},setClear:function(rt){it!==rt&&(it=rt,Z&&(rt=1-rt),i.clearDepth(rt))},reset:function(){R=!1,W=null,ot=null,it=null,Z=!1}}}function s(){let R=!1,Z=null,W=null,ot=null,it=null,rt=null,Et=null,Ft=null,nt=null;return{setTest:function(bt){R||(bt?mt(i.STENCIL_TEST):Nt(i.STENCIL_TEST))},setMask:function(bt){Z!==bt&&!R&&(i.stencilMask(bt),Z=bt)},setFunc:function(bt,Ut,dt){(W!==bt||ot!==Ut||it!==dt)&&(i.stencilFunc(bt,Ut,dt),W=bt,ot=Ut,it=dt)},setOp:function(bt,Ut,dt){(rt!==bt||Et!==Ut||Ft!==dt)&&(i.stencilOp(bt,Ut,dt),rt=bt,Et=Ut,Ft=dt)},setLocked:function(bt){R=bt},setClear:function(bt){nt!==bt&&(i.clearStencil(bt),nt=bt)},reset:function(){R=!1,Z=null,W=null,ot=null,it=null,rt=null,Et=null,Ft=null,nt=null}}}const r=new e,a=new n,o=new s;let l={};const c=new WeakMap;let h={},u={},d={},f=new WeakMap,_=[],S=null,p=!1,m=null,y=null,T=null,M=null,A=null,E=null,g=null,w=new Yt(0,0,0),N=0,C=!1,D=null,B=null,V=null,L=null,H=null;const $=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let G=!1,tt=0;const X=i.getParameter(i.VERSION);X.indexOf("WebGL")!==-1?(tt=parseFloat(/^WebGL (\d)/.exec(X)[1]),G=tt>=1):X.indexOf("OpenGL ES")!==-1&&(tt=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),G=tt>=2);let Q=null,j={};const yt=i.getParameter(i.SCISSOR_BOX),It=i.getParameter(i.VIEWPORT),K=new de().fromArray(yt),pt=new de().fromArray(It);function vt(R,Z,W,ot){const it=new Uint8Array(4),rt=i.createTexture();i.bindTexture(R,rt),i.texParameteri(R,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(R,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Et=0;Et<W;Et++)R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY?i.texImage3D(Z,0,i.RGBA,1,1,ot,0,i.RGBA,i.UNSIGNED_BYTE,it):i.texImage2D(Z+Et,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,it);return rt}const Tt={};Tt[i.TEXTURE_2D]=vt(i.TEXTURE_2D,i.TEXTURE_2D,1),Tt[i.TEXTURE_CUBE_MAP]=vt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Tt[i.TEXTURE_2D_ARRAY]=vt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Tt[i.TEXTURE_3D]=vt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),mt(i.DEPTH_TEST),a.setFunc(Ls),Ge(!1),he(Xc),mt(i.CULL_FACE),Le(Zi);function mt(R){h[R]!==!0&&(i.enable(R),h[R]=!0)}function Nt(R){h[R]!==!1&&(i.disable(R),h[R]=!1)}function me(R,Z){return d[R]!==Z?(i.bindFramebuffer(R,Z),d[R]=Z,R===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=Z),R===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=Z),!0):!1}function Rt(R,Z){let W=_,ot=!1;if(R){W=f.get(Z),W===void 0&&(W=[],f.set(Z,W));const it=R.textures;if(W.length!==it.length||W[0]!==i.COLOR_ATTACHMENT0){for(let rt=0,Et=it.length;rt<Et;rt++)W[rt]=i.COLOR_ATTACHMENT0+rt;W.length=it.length,ot=!0}}else W[0]!==i.BACK&&(W[0]=i.BACK,ot=!0);ot&&i.drawBuffers(W)}function te(R){return S!==R?(i.useProgram(R),S=R,!0):!1}const ie={[$i]:i.FUNC_ADD,[fm]:i.FUNC_SUBTRACT,[pm]:i.FUNC_REVERSE_SUBTRACT};ie[mm]=i.MIN,ie[gm]=i.MAX;const Gt={[_m]:i.ZERO,[vm]:i.ONE,[xm]:i.SRC_COLOR,[Lu]:i.SRC_ALPHA,[bm]:i.SRC_ALPHA_SATURATE,[wm]:i.DST_COLOR,[Mm]:i.DST_ALPHA,[Sm]:i.ONE_MINUS_SRC_COLOR,[Pu]:i.ONE_MINUS_SRC_ALPHA,[Em]:i.ONE_MINUS_DST_COLOR,[ym]:i.ONE_MINUS_DST_ALPHA,[Tm]:i.CONSTANT_COLOR,[Am]:i.ONE_MINUS_CONSTANT_COLOR,[Rm]:i.CONSTANT_ALPHA,[Cm]:i.ONE_MINUS_CONSTANT_ALPHA};function Le(R,Z,W,ot,it,rt,Et,Ft,nt,bt){if(R===Zi){p===!0&&(Nt(i.BLEND),p=!1);return}if(p===!1&&(mt(i.BLEND),p=!0),R!==dm){if(R!==m||bt!==C){if((y!==$i||A!==$i)&&(i.blendEquation(i.FUNC_ADD),y=$i,A=$i),bt)switch(R){case As:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case qc:i.blendFunc(i.ONE,i.ONE);break;case $c:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Yc:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Qt("WebGLState: Invalid blending: ",R);break}else switch(R){case As:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case qc:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case $c:Qt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Yc:Qt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qt("WebGLState: Invalid blending: ",R);break}T=null,M=null,E=null,g=null,w.set(0,0,0),N=0,m=R,C=bt}return}it=it||Z,rt=rt||W,Et=Et||ot,(Z!==y||it!==A)&&(i.blendEquationSeparate(ie[Z],ie[it]),y=Z,A=it),(W!==T||ot!==M||rt!==E||Et!==g)&&(i.blendFuncSeparate(Gt[W],Gt[ot],Gt[rt],Gt[Et]),T=W,M=ot,E=rt,g=Et),(Ft.equals(w)===!1||nt!==N)&&(i.blendColor(Ft.r,Ft.g,Ft.b,nt),w.copy(Ft),N=nt),m=R,C=!1}function Se(R,Z){R.side===bn?Nt(i.CULL_FACE):mt(i.CULL_FACE);let W=R.side===Ve;Z&&(W=!W),Ge(W),R.blending===As&&R.transparent===!1?Le(Zi):Le(R.blending,R.blendEquation,R.blendSrc,R.blendDst,R.blendEquationAlpha,R.blendSrcAlpha,R.blendDstAlpha,R.blendColor,R.blendAlpha,R.premultipliedAlpha),a.setFunc(R.depthFunc),a.setTest(R.depthTest),a.setMask(R.depthWrite),r.setMask(R.colorWrite);const ot=R.stencilWrite;o.setTest(ot),ot&&(o.setMask(R.stencilWriteMask),o.setFunc(R.stencilFunc,R.stencilRef,R.stencilFuncMask),o.setOp(R.stencilFail,R.stencilZFail,R.stencilZPass)),Ee(R.polygonOffset,R.polygonOffsetFactor,R.polygonOffsetUnits),R.alphaToCoverage===!0?mt(i.SAMPLE_ALPHA_TO_COVERAGE):Nt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Ge(R){D!==R&&(R?i.frontFace(i.CW):i.frontFace(i.CCW),D=R)}function he(R){R!==cm?(mt(i.CULL_FACE),R!==B&&(R===Xc?i.cullFace(i.BACK):R===hm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Nt(i.CULL_FACE),B=R}function _n(R){R!==V&&(G&&i.lineWidth(R),V=R)}function Ee(R,Z,W){R?(mt(i.POLYGON_OFFSET_FILL),(L!==Z||H!==W)&&(L=Z,H=W,a.getReversed()&&(Z=-Z,W=-W),i.polygonOffset(Z,W))):Nt(i.POLYGON_OFFSET_FILL)}function Ke(R){R?mt(i.SCISSOR_TEST):Nt(i.SCISSOR_TEST)}function Ze(R){R===void 0&&(R=i.TEXTURE0+$-1),Q!==R&&(i.activeTexture(R),Q=R)}function Je(R,Z,W){W===void 0&&(Q===null?W=i.TEXTURE0+$-1:W=Q);let ot=j[W];ot===void 0&&(ot={type:void 0,texture:void 0},j[W]=ot),(ot.type!==R||ot.texture!==Z)&&(Q!==W&&(i.activeTexture(W),Q=W),i.bindTexture(R,Z||Tt[R]),ot.type=R,ot.texture=Z)}function I(){const R=j[Q];R!==void 0&&R.type!==void 0&&(i.bindTexture(R.type,null),R.type=void 0,R.texture=void 0)}function Qe(){try{i.compressedTexImage2D(...arguments)}catch(R){Qt("WebGLState:",R)}}function oe(){try{i.compressedTexImage3D(...arguments)}catch(R){Qt("WebGLState:",R)}}function le(){try{i.texSubImage2D(...arguments)}catch(R){Qt("WebGLState:",R)}}function ut(){try{i.texSubImage3D(...arguments)}catch(R){Qt("WebGLState:",R)}}function Me(){try{i.compressedTexSubImage2D(...arguments)}catch(R){Qt("WebGLState:",R)}}function At(){try{i.compressedTexSubImage3D(...arguments)}catch(R){Qt("WebGLState:",R)}}function Lt(){try{i.texStorage2D(...arguments)}catch(R){Qt("WebGLState:",R)}}function b(){try{i.texStorage3D(...arguments)}catch(R){Qt("WebGLState:",R)}}function v(){try{i.texImage2D(...arguments)}catch(R){Qt("WebGLState:",R)}}function F(){try{i.texImage3D(...arguments)}catch(R){Qt("WebGLState:",R)}}function et(R){return u[R]!==void 0?u[R]:i.getParameter(R)}function J(R,Z){u[R]!==Z&&(i.pixelStorei(R,Z),u[R]=Z)}function st(R){K.equals(R)===!1&&(i.scissor(R.x,R.y,R.z,R.w),K.copy(R))}function ct(R){pt.equals(R)===!1&&(i.viewport(R.x,R.y,R.z,R.w),pt.copy(R))}function q(R,Z){let W=c.get(Z);W===void 0&&(W=new WeakMap,c.set(Z,W));let ot=W.get(R);ot===void 0&&(ot=i.getUniformBlockIndex(Z,R.name),i.uniformBlockBinding(Z,ot,ot),W.set(R,ot))}function Y(R,Z,W){const it=c.get(Z).get(R);l[it]!==W&&(i.bindBufferBase(i.UNIFORM_BUFFER,it,W),l[it]=W)}function at(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,j={},d={},l={},f=new WeakMap,_=[],S=null,p=!1,m=null,y=null,T=null,M=null,A=null,E=null,g=null,w=new Yt(0,0,0),N=0,C=!1,D=null,B=null,V=null,L=null,H=null,K.set(0,0,i.canvas.width,i.canvas.height),pt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:mt,disable:Nt,bindFramebuffer:me,drawBuffers:Rt,useProgram:te,setBlending:Le,setMaterial:Se,setFlipSided:Ge,setCullFace:he,setLineWidth:_n,setPolygonOffset:Ee,setScissorTest:Ke,activeTexture:Ze,bindTexture:Je,unbindTexture:I,compressedTexImage2D:Qe,compressedTexImage3D:oe,texImage2D:v,texImage3D:F,pixelStorei:J,getParameter:et,updateUBOMapping:q,uniformBlockBinding:Y,texStorage2D:Lt,texStorage3D:b,texSubImage2D:le,texSubImage3D:ut,compressedTexSubImage2D:Me,compressedTexSubImage3D:At,scissor:st,viewport:ct,reset:at}}function dS(i,t,e,n,s,r,a){const o=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Zt,h=new WeakMap,u=new Set;let d;const f=new WeakMap,_=new Set,S=new FinalizationRegistry(b=>_.delete(b));let p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(b,v){return p?new OffscreenCanvas(b,v):qr("canvas")}function y(b,v,F){let et=1;const J=Lt(b);if((J.width>F||J.height>F)&&(et=F/Math.max(J.width,J.height)),et<1)if(typeof HTMLImageElement<"u"&&b instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&b instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&b instanceof ImageBitmap||typeof VideoFrame<"u"&&b instanceof VideoFrame){const st=Math.floor(et*J.width),ct=Math.floor(et*J.height);d===void 0&&(d=m(st,ct));const q=v?m(st,ct):d;return q.width=st,q.height=ct,q.getContext("2d").drawImage(b,0,0,st,ct),Ct("WebGLRenderer: Texture has been resized from ("+J.width+"x"+J.height+") to ("+st+"x"+ct+")."),q}else return"data"in b&&Ct("WebGLRenderer: Image in DataTexture is too big ("+J.width+"x"+J.height+")."),b;return b}function T(b){return b.generateMipmaps}function M(b){i.generateMipmap(b)}function A(b){return b.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:b.isWebGL3DRenderTarget?i.TEXTURE_3D:b.isWebGLArrayRenderTarget||b.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(b,v,F,et,J,st=!1){if(b!==null){if(i[b]!==void 0)return i[b];Ct("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+b+"'")}let ct;et&&(ct=t.get("EXT_texture_norm16"),ct||Ct("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let q=v;if(v===i.RED&&(F===i.FLOAT&&(q=i.R32F),F===i.HALF_FLOAT&&(q=i.R16F),F===i.UNSIGNED_BYTE&&(q=i.R8),F===i.UNSIGNED_SHORT&&ct&&(q=ct.R16_EXT),F===i.SHORT&&ct&&(q=ct.R16_SNORM_EXT)),v===i.RED_INTEGER&&(F===i.UNSIGNED_BYTE&&(q=i.R8UI),F===i.UNSIGNED_SHORT&&(q=i.R16UI),F===i.UNSIGNED_INT&&(q=i.R32UI),F===i.BYTE&&(q=i.R8I),F===i.SHORT&&(q=i.R16I),F===i.INT&&(q=i.R32I)),v===i.RG&&(F===i.FLOAT&&(q=i.RG32F),F===i.HALF_FLOAT&&(q=i.RG16F),F===i.UNSIGNED_BYTE&&(q=i.RG8),F===i.UNSIGNED_SHORT&&ct&&(q=ct.RG16_EXT),F===i.SHORT&&ct&&(q=ct.RG16_SNORM_EXT)),v===i.RG_INTEGER&&(F===i.UNSIGNED_BYTE&&(q=i.RG8UI),F===i.UNSIGNED_SHORT&&(q=i.RG16UI),F===i.UNSIGNED_INT&&(q=i.RG32UI),F===i.BYTE&&(q=i.RG8I),F===i.SHORT&&(q=i.RG16I),F===i.INT&&(q=i.RG32I)),v===i.RGB_INTEGER&&(F===i.UNSIGNED_BYTE&&(q=i.RGB8UI),F===i.UNSIGNED_SHORT&&(q=i.RGB16UI),F===i.UNSIGNED_INT&&(q=i.RGB32UI),F===i.BYTE&&(q=i.RGB8I),F===i.SHORT&&(q=i.RGB16I),F===i.INT&&(q=i.RGB32I)),v===i.RGBA_INTEGER&&(F===i.UNSIGNED_BYTE&&(q=i.RGBA8UI),F===i.UNSIGNED_SHORT&&(q=i.RGBA16UI),F===i.UNSIGNED_INT&&(q=i.RGBA32UI),F===i.BYTE&&(q=i.RGBA8I),F===i.SHORT&&(q=i.RGBA16I),F===i.INT&&(q=i.RGBA32I)),v===i.RGB&&(F===i.UNSIGNED_SHORT&&ct&&(q=ct.RGB16_EXT),F===i.SHORT&&ct&&(q=ct.RGB16_SNORM_EXT),F===i.UNSIGNED_INT_5_9_9_9_REV&&(q=i.RGB9_E5),F===i.UNSIGNED_INT_10F_11F_11F_REV&&(q=i.R11F_G11F_B10F)),v===i.RGBA){const Y=st?Wr:$t.getTransfer(J);F===i.FLOAT&&(q=i.RGBA32F),F===i.HALF_FLOAT&&(q=i.RGBA16F),F===i.UNSIGNED_BYTE&&(q=Y===ne?i.SRGB8_ALPHA8:i.RGBA8),F===i.UNSIGNED_SHORT&&ct&&(q=ct.RGBA16_EXT),F===i.SHORT&&ct&&(q=ct.RGBA16_SNORM_EXT),F===i.UNSIGNED_SHORT_4_4_4_4&&(q=i.RGBA4),F===i.UNSIGNED_SHORT_5_5_5_1&&(q=i.RGB5_A1)}return(q===i.R16F||q===i.R32F||q===i.RG16F||q===i.RG32F||q===i.RGBA16F||q===i.RGBA32F)&&t.get("EXT_color_buffer_float"),q}function g(b,v){let F;return b?v===null||v===an||v===ji?F=i.DEPTH24_STENCIL8:v===sn?F=i.DEPTH32F_STENCIL8:v===Is&&(F=i.DEPTH24_STENCIL8,Ct("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===an||v===ji?F=i.DEPTH_COMPONENT24:v===sn?F=i.DEPTH_COMPONENT32F:v===Is&&(F=i.DEPTH_COMPONENT16),F}function w(b,v){return T(b)===!0||b.isFramebufferTexture&&b.minFilter!==xe&&b.minFilter!==Fe?Math.log2(Math.max(v.width,v.height))+1:b.mipmaps.length>0?b.mipmaps.length:b.isCompressedTexture&&Array.isArray(b.image)?v.mipmaps.length:1}function N(b){const v=new WeakRef(b);n.get(b).__ref=v,_.add(v),S.register(b,v,v)}function C(b){const v=n.get(b).__ref;v!==void 0&&(_.delete(v),S.unregister(v))}function D(b){V(b.target)}function B(b){L(b.target)}function V(b){b.removeEventListener("dispose",D),C(b),$(b),b.isVideoTexture&&h.delete(b),b.isHTMLTexture&&u.delete(b)}function L(b){b.removeEventListener("dispose",B),C(b),tt(b)}function H(){for(const b of _){const v=b.deref();v!==void 0&&(v.isRenderTarget===!0?L(v):V(v))}_.clear(),u.clear()}function $(b){const v=n.get(b);if(v.__webglInit===void 0)return;const F=b.source,et=f.get(F);if(et){const J=et[v.__cacheKey];J.usedTimes--,J.usedTimes===0&&G(b),Object.keys(et).length===0&&f.delete(F)}n.remove(b)}function G(b){const v=n.get(b);i.deleteTexture(v.__webglTexture);const F=b.source,et=f.get(F);delete et[v.__cacheKey],a.memory.textures--}function tt(b){const v=n.get(b);v.__depthDisposeCallback&&v.__depthDisposeCallback();const F=b.depthTexture;if(F&&F.renderTarget===b&&V(F),b.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(v.__webglFramebuffer[J]))for(let st=0;st<v.__webglFramebuffer[J].length;st++)i.deleteFramebuffer(v.__webglFramebuffer[J][st]);else i.deleteFramebuffer(v.__webglFramebuffer[J]);v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer[J])}else{if(Array.isArray(v.__webglFramebuffer))for(let J=0;J<v.__webglFramebuffer.length;J++)i.deleteFramebuffer(v.__webglFramebuffer[J]);else i.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&i.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let J=0;J<v.__webglColorRenderbuffer.length;J++)v.__webglColorRenderbuffer[J]&&i.deleteRenderbuffer(v.__webglColorRenderbuffer[J]);v.__webglDepthRenderbuffer&&i.deleteRenderbuffer(v.__webglDepthRenderbuffer)}const et=b.textures;for(let J=0,st=et.length;J<st;J++){const ct=n.get(et[J]);ct.__webglTexture&&(i.deleteTexture(ct.__webglTexture),a.memory.textures--),n.remove(et[J])}n.remove(b)}let X=0;function Q(){X=0}function j(){return X}function yt(b){X=b}function It(){const b=X;return b>=s.maxTextures&&Ct("WebGLTextures: Trying to use "+(b+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,b}function K(b){const v=[];return v.push(b.wrapS),v.push(b.wrapT),v.push(b.wrapR||0),v.push(b.magFilter),v.push(b.minFilter),v.push(b.anisotropy),v.push(b.internalFormat),v.push(b.format),v.push(b.type),v.push(b.generateMipmaps),v.push(b.mipmapsAutoUpdate),v.push(b.premultiplyAlpha),v.push(b.flipY),v.push(b.unpackAlignment),v.push(b.colorSpace),v.join()}function pt(b,v){const F=n.get(b);if(b.isVideoTexture&&Me(b),b.isRenderTargetTexture===!1&&b.isExternalTexture!==!0&&b.version>0&&F.__version!==b.version){const et=b.image;if(et===null)Ct("WebGLRenderer: Texture marked for update but no image data found.");else if(et.complete===!1)Ct("WebGLRenderer: Texture marked for update but image is incomplete");else{Se(F,b,v);return}}else b.isExternalTexture&&(F.__webglTexture=b.sourceTexture?b.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,F.__webglTexture,i.TEXTURE0+v)}function vt(b,v){const F=n.get(b);if(b.isRenderTargetTexture===!1&&b.version>0&&F.__version!==b.version){Se(F,b,v);return}else b.isExternalTexture&&(F.__webglTexture=b.sourceTexture?b.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,F.__webglTexture,i.TEXTURE0+v)}function Tt(b,v){const F=n.get(b);if(b.isRenderTargetTexture===!1&&b.version>0&&F.__version!==b.version){Se(F,b,v);return}e.bindTexture(i.TEXTURE_3D,F.__webglTexture,i.TEXTURE0+v)}function mt(b,v){const F=n.get(b);if(b.version>0&&F.__version!==b.version){Ge(F,b,v);return}e.bindTexture(i.TEXTURE_CUBE_MAP,F.__webglTexture,i.TEXTURE0+v)}const Nt={[zr]:i.REPEAT,[Gn]:i.CLAMP_TO_EDGE,[Mo]:i.MIRRORED_REPEAT},me={[xe]:i.NEAREST,[Im]:i.NEAREST_MIPMAP_NEAREST,[Ys]:i.NEAREST_MIPMAP_LINEAR,[Fe]:i.LINEAR,[Ta]:i.LINEAR_MIPMAP_NEAREST,[oi]:i.LINEAR_MIPMAP_LINEAR},Rt={[Fm]:i.NEVER,[Ku]:i.ALWAYS,[Om]:i.LESS,[yl]:i.LEQUAL,[km]:i.EQUAL,[Yu]:i.GEQUAL,[Bm]:i.GREATER,[zm]:i.NOTEQUAL};function te(b,v){if(v.type===sn&&t.has("OES_texture_float_linear")===!1&&(v.magFilter===Fe||v.magFilter===Ta||v.magFilter===Ys||v.magFilter===oi||v.minFilter===Fe||v.minFilter===Ta||v.minFilter===Ys||v.minFilter===oi)&&Ct("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(b,i.TEXTURE_WRAP_S,Nt[v.wrapS]),i.texParameteri(b,i.TEXTURE_WRAP_T,Nt[v.wrapT]),(b===i.TEXTURE_3D||b===i.TEXTURE_2D_ARRAY)&&i.texParameteri(b,i.TEXTURE_WRAP_R,Nt[v.wrapR]),i.texParameteri(b,i.TEXTURE_MAG_FILTER,me[v.magFilter]),i.texParameteri(b,i.TEXTURE_MIN_FILTER,me[v.minFilter]),v.compareFunction&&(i.texParameteri(b,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(b,i.TEXTURE_COMPARE_FUNC,Rt[v.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===xe||v.minFilter!==Ys&&v.minFilter!==oi||v.type===sn&&t.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||n.get(v).__currentAnisotropy){const F=t.get("EXT_texture_filter_anisotropic");i.texParameterf(b,F.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,s.getMaxAnisotropy())),n.get(v).__currentAnisotropy=v.anisotropy}}}function ie(b,v){let F=!1;b.__webglInit===void 0&&(b.__webglInit=!0,v.addEventListener("dispose",D),N(v));const et=v.source;let J=f.get(et);J===void 0&&(J={},f.set(et,J));const st=K(v);if(st!==b.__cacheKey){J[st]===void 0&&(J[st]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,F=!0),J[st].usedTimes++;const ct=J[b.__cacheKey];ct!==void 0&&(J[b.__cacheKey].usedTimes--,ct.usedTimes===0&&G(v)),b.__cacheKey=st,b.__webglTexture=J[st].texture}return F}function Gt(b,v,F){return Math.floor(Math.floor(b/F)/v)}function Le(b,v,F,et){const st=b.updateRanges;if(st.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,v.width,v.height,F,et,v.data);else{st.sort((R,Z)=>R.start-Z.start);let ct=0;for(let R=1;R<st.length;R++){const Z=st[ct],W=st[R],ot=Z.start+Z.count,it=Gt(W.start,v.width,4),rt=Gt(Z.start,v.width,4);W.start<=ot+1&&it===rt&&Gt(W.start+W.count-1,v.width,4)===it?Z.count=Math.max(Z.count,W.start+W.count-Z.start):(++ct,st[ct]=W)}st.length=ct+1;const q=e.getParameter(i.UNPACK_ROW_LENGTH),Y=e.getParameter(i.UNPACK_SKIP_PIXELS),at=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,v.width);for(let R=0,Z=st.length;R<Z;R++){const W=st[R],ot=Math.floor(W.start/4),it=Math.ceil(W.count/4),rt=ot%v.width,Et=Math.floor(ot/v.width),Ft=it,nt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Et),e.texSubImage2D(i.TEXTURE_2D,0,rt,Et,Ft,nt,F,et,v.data)}b.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,q),e.pixelStorei(i.UNPACK_SKIP_PIXELS,Y),e.pixelStorei(i.UNPACK_SKIP_ROWS,at)}}function Se(b,v,F){let et=i.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(et=i.TEXTURE_2D_ARRAY),v.isData3DTexture&&(et=i.TEXTURE_3D);const J=ie(b,v),st=v.source;e.bindTexture(et,b.__webglTexture,i.TEXTURE0+F);const ct=n.get(st);if(st.version!==ct.__version||J===!0){if(e.activeTexture(i.TEXTURE0+F),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){const nt=$t.getPrimaries($t.workingColorSpace),bt=v.colorSpace===ai?null:$t.getPrimaries(v.colorSpace),Ut=v.colorSpace===ai||nt===bt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ut)}e.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment);let Y=y(v.image,!1,s.maxTextureSize);Y=At(v,Y);const at=r.convert(v.format,v.colorSpace),R=r.convert(v.type);let Z=E(v.internalFormat,at,R,v.normalized,v.colorSpace,v.isVideoTexture);te(et,v);let W;const ot=v.mipmaps,it=v.isVideoTexture!==!0,rt=ct.__version===void 0||J===!0,Et=st.dataReady,Ft=w(v,Y);if(v.isDepthTexture)Z=g(v.format===li,v.type),rt&&(it?e.texStorage2D(i.TEXTURE_2D,1,Z,Y.width,Y.height):e.texImage2D(i.TEXTURE_2D,0,Z,Y.width,Y.height,0,at,R,null));else if(v.isDataTexture)if(ot.length>0){it&&rt&&e.texStorage2D(i.TEXTURE_2D,Ft,Z,ot[0].width,ot[0].height);for(let nt=0,bt=ot.length;nt<bt;nt++)W=ot[nt],it?Et&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,R,W.data):e.texImage2D(i.TEXTURE_2D,nt,Z,W.width,W.height,0,at,R,W.data);v.generateMipmaps=!1}else it?(rt&&e.texStorage2D(i.TEXTURE_2D,Ft,Z,Y.width,Y.height),Et&&Le(v,Y,at,R)):e.texImage2D(i.TEXTURE_2D,0,Z,Y.width,Y.height,0,at,R,Y.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){it&&rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ft,Z,ot[0].width,ot[0].height,Y.depth);for(let nt=0,bt=ot.length;nt<bt;nt++)if(W=ot[nt],v.format!==rn)if(at!==null)if(it){if(Et)if(v.layerUpdates.size>0){const Ut=gh(W.width,W.height,v.format,v.type);for(const dt of v.layerUpdates){const ee=W.data.subarray(dt*Ut/W.data.BYTES_PER_ELEMENT,(dt+1)*Ut/W.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,dt,W.width,W.height,1,at,ee)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,W.width,W.height,Y.depth,at,W.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,nt,Z,W.width,W.height,Y.depth,0,W.data,0,0);else Ct("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else it?Et&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,W.width,W.height,Y.depth,at,R,W.data):e.texImage3D(i.TEXTURE_2D_ARRAY,nt,Z,W.width,W.height,Y.depth,0,at,R,W.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{it&&rt&&e.texStorage2D(i.TEXTURE_2D,Ft,Z,ot[0].width,ot[0].height);for(let nt=0,bt=ot.length;nt<bt;nt++)W=ot[nt],v.format!==rn?at!==null?it?Et&&e.compressedTexSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,W.data):e.compressedTexImage2D(i.TEXTURE_2D,nt,Z,W.width,W.height,0,W.data):Ct("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):it?Et&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,R,W.data):e.texImage2D(i.TEXTURE_2D,nt,Z,W.width,W.height,0,at,R,W.data)}else if(v.isDataArrayTexture)if(it){if(rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ft,Z,Y.width,Y.height,Y.depth),Et)if(v.layerUpdates.size>0){const nt=gh(Y.width,Y.height,v.format,v.type);for(const bt of v.layerUpdates){const Ut=Y.data.subarray(bt*nt/Y.data.BYTES_PER_ELEMENT,(bt+1)*nt/Y.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,bt,Y.width,Y.height,1,at,R,Ut)}v.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,Y.width,Y.height,Y.depth,at,R,Y.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,Z,Y.width,Y.height,Y.depth,0,at,R,Y.data);else if(v.isData3DTexture)it?(rt&&e.texStorage3D(i.TEXTURE_3D,Ft,Z,Y.width,Y.height,Y.depth),Et&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,Y.width,Y.height,Y.depth,at,R,Y.data)):e.texImage3D(i.TEXTURE_3D,0,Z,Y.width,Y.height,Y.depth,0,at,R,Y.data);else if(v.isFramebufferTexture){if(rt)if(it)e.texStorage2D(i.TEXTURE_2D,Ft,Z,Y.width,Y.height);else{let nt=Y.width,bt=Y.height;for(let Ut=0;Ut<Ft;Ut++)e.texImage2D(i.TEXTURE_2D,Ut,Z,nt,bt,0,at,R,null),nt>>=1,bt>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in i){const nt=i.canvas;if(nt.hasAttribute("layoutsubtree")||nt.setAttribute("layoutsubtree","true"),Y.parentNode!==nt){nt.appendChild(Y),u.add(v),nt.onpaint=bt=>{const Ut=bt.changedElements;for(const dt of u)Ut.includes(dt.image)&&(dt.needsUpdate=!0)},nt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,Y);else{const Ut=i.RGBA,dt=i.RGBA,ee=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Ut,dt,ee,Y)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(ot.length>0){if(it&&rt){const nt=Lt(ot[0]);e.texStorage2D(i.TEXTURE_2D,Ft,Z,nt.width,nt.height)}for(let nt=0,bt=ot.length;nt<bt;nt++)W=ot[nt],it?Et&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,at,R,W):e.texImage2D(i.TEXTURE_2D,nt,Z,at,R,W);v.generateMipmaps=!1}else if(it){if(rt){const nt=Lt(Y);e.texStorage2D(i.TEXTURE_2D,Ft,Z,nt.width,nt.height)}Et&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,at,R,Y)}else e.texImage2D(i.TEXTURE_2D,0,Z,at,R,Y);T(v)&&v.mipmapsAutoUpdate===!0&&M(et),ct.__version=st.version,v.onUpdate&&v.onUpdate(v)}b.__version=v.version}function Ge(b,v,F){if(v.image.length!==6)return;const et=ie(b,v),J=v.source;e.bindTexture(i.TEXTURE_CUBE_MAP,b.__webglTexture,i.TEXTURE0+F);const st=n.get(J);if(J.version!==st.__version||et===!0){e.activeTexture(i.TEXTURE0+F);const ct=$t.getPrimaries($t.workingColorSpace),q=v.colorSpace===ai?null:$t.getPrimaries(v.colorSpace),Y=v.colorSpace===ai||ct===q?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Y);const at=v.isCompressedTexture||v.image[0].isCompressedTexture,R=v.image[0]&&v.image[0].isDataTexture,Z=[];for(let dt=0;dt<6;dt++)!at&&!R?Z[dt]=y(v.image[dt],!0,s.maxCubemapSize):Z[dt]=R?v.image[dt].image:v.image[dt],Z[dt]=At(v,Z[dt]);const W=Z[0],ot=r.convert(v.format,v.colorSpace),it=r.convert(v.type);let rt=E(v.internalFormat,ot,it,v.normalized,v.colorSpace);const Et=v.isVideoTexture!==!0,Ft=st.__version===void 0||et===!0,nt=J.dataReady;let bt=w(v,W);te(i.TEXTURE_CUBE_MAP,v);let Ut;if(v.isDepthTexture){if(rt=g(v.format===li,v.type),Ft)if(Et)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,rt,W.width,W.height);else for(let dt=0;dt<6;dt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,W.width,W.height,0,ot,it,null)}else if(at){Et&&Ft&&e.texStorage2D(i.TEXTURE_CUBE_MAP,bt,rt,W.width,W.height);for(let dt=0;dt<6;dt++){Ut=Z[dt].mipmaps;for(let ee=0;ee<Ut.length;ee++){const be=Ut[ee];v.format!==rn?ot!==null?Et?nt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee,0,0,be.width,be.height,ot,be.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee,rt,be.width,be.height,0,be.data):Ct("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Et?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee,0,0,be.width,be.height,ot,it,be.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee,rt,be.width,be.height,0,ot,it,be.data)}}}else{if(Ut=v.mipmaps,Et&&Ft){Ut.length>0&&bt++;const dt=Lt(Z[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,bt,rt,dt.width,dt.height)}for(let dt=0;dt<6;dt++)if(R){Et?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,0,0,Z[dt].width,Z[dt].height,ot,it,Z[dt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,Z[dt].width,Z[dt].height,0,ot,it,Z[dt].data);for(let ee=0;ee<Ut.length;ee++){const Kn=Ut[ee].image[dt].image;Et?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee+1,0,0,Kn.width,Kn.height,ot,it,Kn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee+1,rt,Kn.width,Kn.height,0,ot,it,Kn.data)}}else{Et?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,0,0,ot,it,Z[dt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,ot,it,Z[dt]);for(let ee=0;ee<Ut.length;ee++){const be=Ut[ee];Et?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee+1,0,0,ot,it,be.image[dt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee+1,rt,ot,it,be.image[dt])}}}T(v)&&v.mipmapsAutoUpdate===!0&&M(i.TEXTURE_CUBE_MAP),st.__version=J.version,v.onUpdate&&v.onUpdate(v)}b.__version=v.version}function he(b,v,F,et,J,st){const ct=r.convert(F.format,F.colorSpace),q=r.convert(F.type),Y=E(F.internalFormat,ct,q,F.normalized,F.colorSpace),at=n.get(v),R=n.get(F);if(R.__renderTarget=v,!at.__hasExternalTextures){const Z=Math.max(1,v.width>>st),W=Math.max(1,v.height>>st);J===i.TEXTURE_3D||J===i.TEXTURE_2D_ARRAY?e.texImage3D(J,st,Y,Z,W,v.depth,0,ct,q,null):e.texImage2D(J,st,Y,Z,W,0,ct,q,null)}e.bindFramebuffer(i.FRAMEBUFFER,b),ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,et,J,R.__webglTexture,0,le(v)):(J===i.TEXTURE_2D||J>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&J<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,et,J,R.__webglTexture,st),e.bindFramebuffer(i.FRAMEBUFFER,null)}function _n(b,v,F){if(i.bindRenderbuffer(i.RENDERBUFFER,b),v.depthBuffer){const et=v.depthTexture,J=et&&et.isDepthTexture?et.type:null,st=g(v.stencilBuffer,J),ct=v.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;ut(v)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,le(v),st,v.width,v.height):F?i.renderbufferStorageMultisample(i.RENDERBUFFER,le(v),st,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,st,v.width,v.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ct,i.RENDERBUFFER,b)}else{const et=v.textures;for(let J=0;J<et.length;J++){const st=et[J],ct=r.convert(st.format,st.colorSpace),q=r.convert(st.type),Y=E(st.internalFormat,ct,q,st.normalized,st.colorSpace);ut(v)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,le(v),Y,v.width,v.height):F?i.renderbufferStorageMultisample(i.RENDERBUFFER,le(v),Y,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,Y,v.width,v.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Ee(b,v,F){const et=v.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,b),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");const J=n.get(v.depthTexture);J.__renderTarget=v;const st=et?v.depthTexture.image[0]:v.depthTexture.image;(!J.__webglTexture||st.width!==v.width||st.height!==v.height)&&(st.width=v.width,st.height=v.height,v.depthTexture.needsUpdate=!0),et?mt(v.depthTexture,0):pt(v.depthTexture,0);const ct=J.__webglTexture,q=le(v),Y=et?i.TEXTURE_CUBE_MAP_POSITIVE_X+F:i.TEXTURE_2D,at=v.depthTexture.format===li?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(v.depthTexture.format===hi)ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,Y,ct,0,q):i.framebufferTexture2D(i.FRAMEBUFFER,at,Y,ct,0);else if(v.depthTexture.format===li)ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,Y,ct,0,q):i.framebufferTexture2D(i.FRAMEBUFFER,at,Y,ct,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Ke(b){const v=n.get(b),F=b.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==b.depthTexture){const et=b.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),et){const J=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,et.removeEventListener("dispose",J)};et.addEventListener("dispose",J),v.__depthDisposeCallback=J}v.__boundDepthTexture=et}if(b.depthTexture&&!v.__autoAllocateDepthBuffer)if(F)for(let et=0;et<6;et++)Ee(v.__webglFramebuffer[et],b,et);else b.texture.mipmaps.length>0?Ee(v.__webglFramebuffer[0],b,0):Ee(v.__webglFramebuffer,b,0);else if(F){v.__webglDepthbuffer=[];for(let et=0;et<6;et++)if(e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[et]),v.__webglDepthbuffer[et]===void 0)v.__webglDepthbuffer[et]=i.createRenderbuffer(),_n(v.__webglDepthbuffer[et],b,!1);else{const J=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=v.__webglDepthbuffer[et];i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,J,i.RENDERBUFFER,st)}}else if(b.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=i.createRenderbuffer(),_n(v.__webglDepthbuffer,b,!1);else{const J=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=v.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,J,i.RENDERBUFFER,st)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ze(b,v,F){const et=n.get(b);v!==void 0&&he(et.__webglFramebuffer,b,b.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),F!==void 0&&Ke(b)}function Je(b){const v=b.texture,F=n.get(b),et=n.get(v);b.addEventListener("dispose",B),N(b);const J=b.textures,st=b.isWebGLCubeRenderTarget===!0,ct=J.length>1;if(ct||(et.__webglTexture===void 0&&(et.__webglTexture=i.createTexture()),et.__version=v.version,a.memory.textures++),st){F.__webglFramebuffer=[];for(let q=0;q<6;q++)if(v.mipmaps.length>0){F.__webglFramebuffer[q]=[];for(let Y=0;Y<v.mipmaps.length;Y++)F.__webglFramebuffer[q][Y]=i.createFramebuffer()}else F.__webglFramebuffer[q]=i.createFramebuffer()}else{if(v.mipmaps.length>0){F.__webglFramebuffer=[];for(let q=0;q<v.mipmaps.length;q++)F.__webglFramebuffer[q]=i.createFramebuffer()}else F.__webglFramebuffer=i.createFramebuffer();if(ct)for(let q=0,Y=J.length;q<Y;q++){const at=n.get(J[q]);at.__webglTexture===void 0&&(at.__webglTexture=i.createTexture(),a.memory.textures++)}if(b.samples>0&&ut(b)===!1){F.__webglMultisampledFramebuffer=i.createFramebuffer(),F.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,F.__webglMultisampledFramebuffer);for(let q=0;q<J.length;q++){const Y=J[q];F.__webglColorRenderbuffer[q]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,F.__webglColorRenderbuffer[q]);const at=r.convert(Y.format,Y.colorSpace),R=r.convert(Y.type),Z=E(Y.internalFormat,at,R,Y.normalized,Y.colorSpace,b.isXRRenderTarget===!0),W=le(b);i.renderbufferStorageMultisample(i.RENDERBUFFER,W,Z,b.width,b.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+q,i.RENDERBUFFER,F.__webglColorRenderbuffer[q])}i.bindRenderbuffer(i.RENDERBUFFER,null),b.depthBuffer&&(F.__webglDepthRenderbuffer=i.createRenderbuffer(),_n(F.__webglDepthRenderbuffer,b,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(st){e.bindTexture(i.TEXTURE_CUBE_MAP,et.__webglTexture),te(i.TEXTURE_CUBE_MAP,v);for(let q=0;q<6;q++)if(v.mipmaps.length>0)for(let Y=0;Y<v.mipmaps.length;Y++)he(F.__webglFramebuffer[q][Y],b,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+q,Y);else he(F.__webglFramebuffer[q],b,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+q,0);T(v)?M(i.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}else if(ct){for(let q=0,Y=J.length;q<Y;q++){const at=J[q],R=n.get(at);let Z=i.TEXTURE_2D;(b.isWebGL3DRenderTarget||b.isWebGLArrayRenderTarget)&&(Z=b.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(Z,R.__webglTexture),te(Z,at),he(F.__webglFramebuffer,b,at,i.COLOR_ATTACHMENT0+q,Z,0),T(at)&&M(Z)}e.unbindTexture()}else{let q=i.TEXTURE_2D;if((b.isWebGL3DRenderTarget||b.isWebGLArrayRenderTarget)&&(q=b.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(q,et.__webglTexture),te(q,v),v.mipmaps.length>0)for(let Y=0;Y<v.mipmaps.length;Y++)he(F.__webglFramebuffer[Y],b,v,i.COLOR_ATTACHMENT0,q,Y);else he(F.__webglFramebuffer,b,v,i.COLOR_ATTACHMENT0,q,0);T(v)?M(q):v.mipmaps.length>0&&i.texParameteri(q,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}b.depthBuffer&&Ke(b)}function I(b){const v=b.textures;for(let F=0,et=v.length;F<et;F++){const J=v[F];if(T(J)&&J.mipmapsAutoUpdate===!0){const st=A(b),ct=n.get(J).__webglTexture;e.bindTexture(st,ct),M(st),e.unbindTexture()}}}const Qe=[];function oe(b){if(b.samples>0){if(ut(b)===!1){const v=b.textures,F=b.width,et=b.height;let J=i.COLOR_BUFFER_BIT;const st=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ct=n.get(b),q=v.length>1;if(q)for(let at=0;at<v.length;at++)e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,ct.__webglMultisampledFramebuffer),b.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer);for(let at=0;at<v.length;at++){if(b.resolveDepthBuffer&&(b.depthBuffer&&(J|=i.DEPTH_BUFFER_BIT),b.stencilBuffer&&b.resolveStencilBuffer&&(J|=i.STENCIL_BUFFER_BIT)),q){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ct.__webglColorRenderbuffer[at]);const R=n.get(v[at]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,R,0)}i.blitFramebuffer(0,0,F,et,0,0,F,et,J,i.NEAREST),l===!0&&(Qe.length=0,Qe.push(i.COLOR_ATTACHMENT0+at),b.depthBuffer&&b.storeMultisampledDepthBuffer===!1&&Qe.push(st),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Qe))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),q)for(let at=0;at<v.length;at++){e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,ct.__webglColorRenderbuffer[at]);const R=n.get(v[at]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,R,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglMultisampledFramebuffer)}else if(b.depthBuffer&&b.storeMultisampledDepthBuffer===!1&&l){const v=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[v])}}}function le(b){return Math.min(s.maxSamples,b.samples)}function ut(b){const v=n.get(b);return b.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function Me(b){const v=a.render.frame;h.get(b)!==v&&(h.set(b,v),b.update())}function At(b,v){const F=b.colorSpace,et=b.format,J=b.type;return b.isCompressedTexture===!0||b.isVideoTexture===!0||F!==Vr&&F!==ai&&($t.getTransfer(F)===ne?(et!==rn||J!==en)&&Ct("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qt("WebGLTextures: Unsupported texture color space:",F)),v}function Lt(b){return typeof HTMLImageElement<"u"&&b instanceof HTMLImageElement?(c.width=b.naturalWidth||b.width,c.height=b.naturalHeight||b.height):typeof VideoFrame<"u"&&b instanceof VideoFrame?(c.width=b.displayWidth,c.height=b.displayHeight):(c.width=b.width,c.height=b.height),c}this.allocateTextureUnit=It,this.resetTextureUnits=Q,this.getTextureUnits=j,this.setTextureUnits=yt,this.setTexture2D=pt,this.setTexture2DArray=vt,this.setTexture3D=Tt,this.setTextureCube=mt,this.rebindTextures=Ze,this.setupRenderTarget=Je,this.updateRenderTargetMipmap=I,this.updateMultisampleRenderTarget=oe,this.setupDepthRenderbuffer=Ke,this.setupFrameBufferTexture=he,this.useMultisampledRTT=ut,this.dispose=H}function fS(i,t){function e(n,s=ai){let r;const a=$t.getTransfer(s);if(n===en)return i.UNSIGNED_BYTE;if(n===vl)return i.UNSIGNED_SHORT_4_4_4_4;if(n===xl)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Vu)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Wu)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Gu)return i.BYTE;if(n===Hu)return i.SHORT;if(n===Is)return i.UNSIGNED_SHORT;if(n===_l)return i.INT;if(n===an)return i.UNSIGNED_INT;if(n===sn)return i.FLOAT;if(n===gn)return i.HALF_FLOAT;if(n===Xu)return i.ALPHA;if(n===qu)return i.RGB;if(n===rn)return i.RGBA;if(n===hi)return i.DEPTH_COMPONENT;if(n===li)return i.DEPTH_STENCIL;if(n===$u)return i.RED;if(n===Sl)return i.RED_INTEGER;if(n===ui)return i.RG;if(n===Qr)return i.RG_INTEGER;if(n===Ml)return i.RGBA_INTEGER;if(n===Rr||n===Cr||n===Lr||n===Pr)if(a===ne)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Rr)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Cr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Lr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Pr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Rr)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Cr)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Lr)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Pr)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===yo||n===wo||n===Eo||n===bo)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===yo)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===wo)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Eo)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===bo)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===To||n===Ao||n===Ro||n===Co||n===Lo||n===Gr||n===Po)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===To||n===Ao)return a===ne?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Ro)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Co)return r.COMPRESSED_R11_EAC;if(n===Lo)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Gr)return r.COMPRESSED_RG11_EAC;if(n===Po)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Io||n===Do||n===No||n===Uo||n===Fo||n===Oo||n===ko||n===Bo||n===zo||n===Go||n===Ho||n===Vo||n===Wo||n===Xo)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Io)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Do)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===No)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Uo)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Fo)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Oo)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===ko)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Bo)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===zo)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Go)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ho)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Vo)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Wo)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Xo)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===qo||n===$o||n===Yo)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===qo)return a===ne?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===$o)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Yo)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Ko||n===Zo||n===Hr||n===Jo)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Ko)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Zo)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Hr)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Jo)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===ji?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}const pS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,mS=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`;class gS{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){const n=new sd(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){const e=t.cameras[0].viewport,n=new Ii({vertexShader:pS,fragmentShader:mS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new $n(new ea(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class _S extends Di{constructor(t,e){super();const n=this;let s=null,r=1,a=null,o="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,_=null;const S=typeof XRWebGLBinding<"u",p=new gS,m={},y=e.getContextAttributes();let T=null,M=null;const A=[],E=[],g=new Zt;let w=null,N=null;const C=new dn;C.viewport=new de;const D=new dn;D.viewport=new de;const B=[C,D],V=new C0;let L=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(K){let pt=A[K];return pt===void 0&&(pt=new Ua,A[K]=pt),pt.getTargetRaySpace()},this.getControllerGrip=function(K){let pt=A[K];return pt===void 0&&(pt=new Ua,A[K]=pt),pt.getGripSpace()},this.getHand=function(K){let pt=A[K];return pt===void 0&&(pt=new Ua,A[K]=pt),pt.getHandSpace()};function $(K){const pt=E.indexOf(K.inputSource);if(pt===-1)return;const vt=A[pt];vt!==void 0&&(vt.update(K.inputSource,K.frame,c||a),vt.dispatchEvent({type:K.type,data:K.inputSource}))}function G(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",tt);for(let K=0;K<A.length;K++){const pt=E[K];pt!==null&&(E[K]=null,A[K].disconnect(pt))}L=null,H=null,p.reset();for(const K in m)delete m[K];if(t.setRenderTarget(T),f=null,d=null,u=null,s=null,M=null,It.stop(),n.isPresenting=!1,t.setPixelRatio(w),t.setSize(g.width,g.height,!1),N!==null){const K=N.camera;K.fov=N.fov,K.zoom=N.zoom,K.updateProjectionMatrix(),N=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(K){r=K,n.isPresenting===!0&&Ct("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(K){o=K,n.isPresenting===!0&&Ct("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(K){c=K},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&S&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(K){if(s=K,s!==null){if(T=t.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",G),s.addEventListener("inputsourceschange",tt),y.xrCompatible!==!0&&await e.makeXRCompatible(),w=t.getPixelRatio(),t.getSize(g),S&&"createProjectionLayer"in XRWebGLBinding.prototype){let vt=null,Tt=null,mt=null;y.depth&&(mt=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,vt=y.stencil?li:hi,Tt=y.stencil?ji:an);const Nt={colorFormat:e.RGBA8,depthFormat:mt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Nt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),M=new mn(d.textureWidth,d.textureHeight,{format:rn,type:en,depthTexture:new Pi(d.textureWidth,d.textureHeight,Tt,void 0,void 0,void 0,void 0,void 0,void 0,vt),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{const vt={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,vt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),M=new mn(f.framebufferWidth,f.framebufferHeight,{format:rn,type:en,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),It.setContext(s),It.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function tt(K){for(let pt=0;pt<K.removed.length;pt++){const vt=K.removed[pt],Tt=E.indexOf(vt);Tt>=0&&(E[Tt]=null,A[Tt].disconnect(vt))}for(let pt=0;pt<K.added.length;pt++){const vt=K.added[pt];let Tt=E.indexOf(vt);if(Tt===-1){for(let Nt=0;Nt<A.length;Nt++)if(Nt>=E.length){E.push(vt),Tt=Nt;break}else if(E[Nt]===null){E[Nt]=vt,Tt=Nt;break}if(Tt===-1)break}const mt=A[Tt];mt&&mt.connect(vt)}}function X(K,pt){pt===null?K.matrixWorld.copy(K.matrix):K.matrixWorld.multiplyMatrices(pt.matrixWorld,K.matrix),K.matrixWorldInverse.copy(K.matrixWorld).invert()}this.updateCamera=function(K){if(s===null)return;let pt=K.near,vt=K.far;p.texture!==null&&(p.depthNear>0&&(pt=p.depthNear),p.depthFar>0&&(vt=p.depthFar)),V.near=D.near=C.near=pt,V.far=D.far=C.far=vt,(L!==V.near||H!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),L=V.near,H=V.far),V.layers.mask=K.layers.mask|6,C.layers.mask=V.layers.mask&-5,D.layers.mask=V.layers.mask&-3;const Tt=K.parent,mt=V.cameras;X(V,Tt);for(let Nt=0;Nt<mt.length;Nt++)X(mt[Nt],Tt);V.projectionMatrix.copy(C.projectionMatrix),V.projectionMatrixInverse.copy(C.projectionMatrixInverse),N===null&&K.isPerspectiveCamera&&(N={camera:K,fov:K.fov,zoom:K.zoom}),Q(K,V,Tt)};function Q(K,pt,vt){vt===null?K.matrix.copy(pt.matrixWorld):(K.matrix.copy(vt.matrixWorld),K.matrix.invert(),K.matrix.multiply(pt.matrixWorld)),K.matrix.decompose(K.position,K.quaternion,K.scale),K.updateMatrixWorld(!0),K.projectionMatrix.copy(pt.projectionMatrix),K.projectionMatrixInverse.copy(pt.projectionMatrixInverse),K.isPerspectiveCamera&&(K.fov=Qo*2*Math.atan(1/K.projectionMatrix.elements[5]),K.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(K){l=K,d!==null&&(d.fixedFoveation=K),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=K)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(V)},this.getCameraTexture=function(K){return m[K]};let j=null;function yt(K,pt){if(h=pt.getViewerPose(c||a),_=pt,h!==null){const vt=h.views;f!==null&&(t.setRenderTargetFramebuffer(M,f.framebuffer),t.setRenderTarget(M));let Tt=!1;vt.length!==V.cameras.length&&(V.cameras.length=0,Tt=!0);for(let Rt=0;Rt<vt.length;Rt++){const te=vt[Rt];let ie=null;if(f!==null)ie=f.getViewport(te);else{const Le=u.getViewSubImage(d,te);ie=Le.viewport,Rt===0&&(t.setRenderTargetTextures(M,Le.colorTexture,Le.depthStencilTexture),t.setRenderTarget(M))}let Gt=B[Rt];Gt===void 0&&(Gt=new dn,Gt.layers.enable(Rt),Gt.viewport=new de,B[Rt]=Gt),Gt.matrix.fromArray(te.transform.matrix),Gt.matrix.decompose(Gt.position,Gt.quaternion,Gt.scale),Gt.projectionMatrix.fromArray(te.projectionMatrix),Gt.projectionMatrixInverse.copy(Gt.projectionMatrix).invert(),Gt.viewport.set(ie.x,ie.y,ie.width,ie.height),Rt===0&&(V.matrix.copy(Gt.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Tt===!0&&V.cameras.push(Gt)}const mt=s.enabledFeatures;if(mt&&mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&S){u=n.getBinding();const Rt=u.getDepthInformation(vt[0]);Rt&&Rt.isValid&&Rt.texture&&p.init(Rt,s.renderState)}if(mt&&mt.includes("camera-access")&&S){t.state.unbindTexture(),u=n.getBinding();for(let Rt=0;Rt<vt.length;Rt++){const te=vt[Rt].camera;if(te){let ie=m[te];ie||(ie=new sd,m[te]=ie);const Gt=u.getCameraImage(te);ie.sourceTexture=Gt}}}}for(let vt=0;vt<A.length;vt++){const Tt=E[vt],mt=A[vt];Tt!==null&&mt!==void 0&&mt.update(Tt,pt,c||a)}j&&j(K,pt),pt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:pt}),_=null}const It=new od;It.setAnimationLoop(yt),this.setAnimationLoop=function(K){j=K},this.dispose=function(){}}}const vS=new jt,_d=new Pt;_d.set(-1,0,0,0,1,0,0,0,1);function xS(i,t){function e(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function n(p,m){m.color.getRGB(p.fogColor.value,rd(i)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,y,T,M){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),u(p,m)):m.isMeshPhongMaterial?(r(p,m),h(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),d(p,m),m.isMeshPhysicalMaterial&&f(p,m,M)):m.isMeshMatcapMaterial?(r(p,m),_(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),S(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(a(p,m),m.isLineDashedMaterial&&o(p,m)):m.isPointsMaterial?l(p,m,y,T):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,e(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===Ve&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,e(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===Ve&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,e(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,e(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);const y=t.get(m),T=y.envMap,M=y.envMapRotation;T&&(p.envMap.value=T,p.envMapRotation.value.setFromMatrix4(vS.makeRotationFromEuler(M)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(_d),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,p.aoMapTransform))}function a(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform))}function o(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,y,T){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*y,p.scale.value=T*.5,m.map&&(p.map.value=m.map,e(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function h(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function u(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function d(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,y){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Ve&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=y.texture,p.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,p.specularIntensityMapTransform))}function _(p,m){m.matcap&&(p.matcap.value=m.matcap)}function S(p,m){const y=t.get(m).light;p.referencePosition.value.setFromMatrixPosition(y.matrixWorld),p.nearDistance.value=y.shadow.camera.near,p.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function SS(i,t,e,n){let s={},r={};function a(y,T){const M=T.program;n.uniformBlockBinding(y,M,s[y.id])}function o(y,T){let M=s[y.id];M===void 0&&(_(y),M=l(y),s[y.id]=M,y.addEventListener("dispose",p));const A=T.program;n.updateUBOMapping(y,A);const E=t.render.frame;r[y.id]!==E&&(c(y),r[y.id]=E)}function l(y){const T=i.createBuffer(),M=y.__size,A=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,T),i.bufferData(i.UNIFORM_BUFFER,M,A),i.bindBuffer(i.UNIFORM_BUFFER,null),T}function c(y){const T=s[y.id],M=y.uniforms,A=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let E=0,g=M.length;E<g;E++){const w=M[E];if(Array.isArray(w))for(let N=0,C=w.length;N<C;N++)h(w[N],E,N,A);else h(w,E,0,A)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(y,T,M,A){if(d(y,T,M,A)===!0){const E=y.__offset,g=y.value;if(Array.isArray(g)){let w=0;for(let N=0;N<g.length;N++){const C=g[N],D=S(C,!0);u(C,y.__data,w),w+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(g,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,y.__data)}}function u(y,T,M){typeof y=="number"||typeof y=="boolean"?T[M]=y:y.isMatrix3?(T[M]=y.elements[0],T[M+1]=y.elements[1],T[M+2]=y.elements[2],T[M+3]=0,T[M+4]=y.elements[3],T[M+5]=y.elements[4],T[M+6]=y.elements[5],T[M+7]=0,T[M+8]=y.elements[6],T[M+9]=y.elements[7],T[M+10]=y.elements[8],T[M+11]=0):ArrayBuffer.isView(y)?T.set(y.subarray(0,T.length-M),M):y.toArray(T,M)}function d(y,T,M,A){const E=y.value,g=T+"_"+M;if(Array.isArray(E)){A[g]===void 0&&(A[g]=[]);const w=A[g];let N=!1;for(let C=0;C<E.length;C++)f(E[C],w,C)===!0&&(N=!0);return N}return f(E,A,g)}function f(y,T,M){if(T[M]===void 0)return typeof y=="number"||typeof y=="boolean"?T[M]=y:ArrayBuffer.isView(y)?T[M]=y.slice():T[M]=y.clone(),!0;{const A=T[M];if(typeof y=="number"||typeof y=="boolean"){if(A!==y)return T[M]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(A.equals(y)===!1)return A.copy(y),!0}}return!1}function _(y){const T=y.uniforms;let M=0;const A=16;for(let g=0,w=T.length;g<w;g++){const N=Array.isArray(T[g])?T[g]:[T[g]];for(let C=0,D=N.length;C<D;C++){const B=N[C],V=Array.isArray(B.value)?B.value:[B.value],L=Array.isArray(T[g])||Array.isArray(B.value);let H=M;for(let G=0,tt=V.length;G<tt;G++){const X=V[G],Q=S(X,L),j=M%A,yt=j%Q.boundary,It=j+yt;M+=yt,It!==0&&A-It<Q.storage&&(M+=A-It),G===0&&(H=M),M+=Q.storage}const $=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new $((M-H)/Float32Array.BYTES_PER_ELEMENT),B.__offset=H}}const E=M%A;return E>0&&(M+=A-E),y.__size=M,y.__cache={},this}function S(y,T){const M={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(M.boundary=4,M.storage=4):y.isVector2?(M.boundary=8,M.storage=8):y.isVector3||y.isColor?(M.boundary=16,M.storage=12):y.isVector4?(M.boundary=16,M.storage=16):y.isMatrix3?(M.boundary=16,M.storage=48):y.isMatrix4?(M.boundary=16,M.storage=64):y.isTexture?Ct("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(M.boundary=16,M.storage=y.byteLength):Ct("WebGLRenderer: Unsupported uniform value type.",y),T===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function p(y){const T=y.target;T.removeEventListener("dispose",p),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function m(){for(const y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:a,update:o,dispose:m}}const MS=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]);let Mn=null;function yS(){return Mn===null&&(Mn=new ta(MS,16,16,ui,gn),Mn.name="DFG_LUT",Mn.minFilter=Fe,Mn.magFilter=Fe,Mn.wrapS=Gn,Mn.wrapT=Gn,Mn.generateMipmaps=!1,Mn.needsUpdate=!0),Mn}class wS{constructor(t={}){const{canvas:e=Vm(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=en}=t;this.isWebGLRenderer=!0;let _;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");_=n.getContextAttributes().alpha}else _=a;const S=f,p=new Set([Ml,Qr,Sl]),m=new Set([en,an,Is,ji,vl,xl]),y=new Uint32Array(4),T=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]};let A=null,E=null;const g=[],w=[];let N=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Vn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;const C=this;let D=!1,B=null,V=null,L=null,H=null;this._outputColorSpace=tn;let $=0,G=0,tt=null,X=-1,Q=null;const j=new de,yt=new de;let It=null;const K=new Yt(0);let pt=0,vt=e.width,Tt=e.height,mt=1,Nt=null,me=null;const Rt=new de(0,0,vt,Tt),te=new de(0,0,vt,Tt);let ie=!1;const Gt=new $r,Le=new Al;let Se=!1,Ge=!1;const he=new jt,_n=new O,Ee=new de,Ke={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Ze=!1;function Je(){return tt===null?mt:1}let I=n;function Qe(x,P){return e.getContext(x,P)}let oe,le,ut,Me,At,Lt,b,v,F,et,J,st,ct,q,Y,at,R,Z,W,ot,it,rt,Et;try{const x={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${gl}`),e.addEventListener("webglcontextlost",bt,!1),e.addEventListener("webglcontextrestored",Ut,!1),e.addEventListener("webglcontextcreationerror",dt,!1),I===null){const P="webgl2";if(I=Qe(P,x),I===null)throw Qe(P)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ft()}catch(x){throw e.removeEventListener("webglcontextlost",bt,!1),e.removeEventListener("webglcontextrestored",Ut,!1),e.removeEventListener("webglcontextcreationerror",dt,!1),Qt("WebGLRenderer: "+x.message),x}function Ft(){oe=new Tv(I),oe.init(),it=new fS(I,oe),le=new mv(I,oe,t,it),ut=new uS(I,oe),le.reversedDepthBuffer&&d&&ut.buffers.depth.setReversed(!0),V=I.createFramebuffer(),L=I.createFramebuffer(),H=I.createFramebuffer(),Me=new Cv(I),At=new Jx,Lt=new dS(I,oe,ut,At,le,it,Me),b=new bv(C),v=new P0(I),rt=new fv(I,v),F=new Av(I,v,Me,rt),et=new Pv(I,F,v,rt,Me),Z=new Lv(I,le,Lt),Y=new gv(At),J=new Zx(C,b,oe,le,rt,Y),st=new xS(C,At),ct=new jx,q=new rS(oe),R=new dv(C,b,ut,et,_,l),at=new hS(C,et,le),Et=new SS(I,Me,le,ut),W=new pv(I,oe,Me),ot=new Rv(I,oe,Me),Me.programs=J.programs,C.capabilities=le,C.extensions=oe,C.properties=At,C.renderLists=ct,C.shadowMap=at,C.state=ut,C.info=Me}S!==en&&(N=new Dv(S,e.width,e.height,o,s,r));const nt=new _S(C,I);this.xr=nt,this.getContext=function(){return I},this.getContextAttributes=function(){return I.getContextAttributes()},this.forceContextLoss=function(){const x=oe.get("WEBGL_lose_context");x&&x.loseContext()},this.forceContextRestore=function(){const x=oe.get("WEBGL_lose_context");x&&x.restoreContext()},this.getPixelRatio=function(){return mt},this.setPixelRatio=function(x){x!==void 0&&(mt=x,this.setSize(vt,Tt,!1))},this.getSize=function(x){return x.set(vt,Tt)},this.setSize=function(x,P,z=!0){if(nt.isPresenting){Ct("WebGLRenderer: Can't change size while VR device is presenting.");return}vt=x,Tt=P,e.width=Math.floor(x*mt),e.height=Math.floor(P*mt),z===!0&&(e.style.width=x+"px",e.style.height=P+"px"),N!==null&&N.setSize(e.width,e.height),this.setViewport(0,0,x,P)},this.getDrawingBufferSize=function(x){return x.set(vt*mt,Tt*mt).floor()},this.setDrawingBufferSize=function(x,P,z){vt=x,Tt=P,mt=z,e.width=Math.floor(x*z),e.height=Math.floor(P*z),this.setViewport(0,0,x,P)},this.setEffects=function(x){if(S===en){Qt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(x){for(let P=0;P<x.length;P++)if(x[P].isOutputPass===!0){Ct("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(x||[])},this.getCurrentViewport=function(x){return x.copy(j)},this.getViewport=function(x){return x.copy(Rt)},this.setViewport=function(x,P,z,U){x.isVector4?Rt.set(x.x,x.y,x.z,x.w):Rt.set(x,P,z,U),ut.viewport(j.copy(Rt).multiplyScalar(Je()).round())},this.getScissor=function(x){return x.copy(te)},this.setScissor=function(x,P,z,U){x.isVector4?te.set(x.x,x.y,x.z,x.w):te.set(x,P,z,U),ut.scissor(yt.copy(te).multiplyScalar(Je()).round())},this.getScissorTest=function(){return ie},this.setScissorTest=function(x){ut.setScissorTest(ie=x)},this.setOpaqueSort=function(x){Nt=x},this.setTransparentSort=function(x){me=x},this.getClearColor=function(x){return x.copy(R.getClearColor())},this.setClearColor=function(){R.setClearColor(...arguments)},this.getClearAlpha=function(){return R.getClearAlpha()},this.setClearAlpha=function(){R.setClearAlpha(...arguments)},this.clear=function(x=!0,P=!0,z=!0){let U=0;if(x){let k=!1;if(tt!==null){const ht=tt.texture.format;k=p.has(ht)}if(k){const ht=tt.texture.type,_t=m.has(ht),lt=R.getClearColor(),gt=R.getClearAlpha(),wt=lt.r,Dt=lt.g,Ht=lt.b;_t?(y[0]=wt,y[1]=Dt,y[2]=Ht,y[3]=gt,I.clearBufferuiv(I.COLOR,0,y)):(T[0]=wt,T[1]=Dt,T[2]=Ht,T[3]=gt,I.clearBufferiv(I.COLOR,0,T))}else U|=I.COLOR_BUFFER_BIT}P&&(U|=I.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),z&&(U|=I.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),U!==0&&I.clear(U)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(x){x.setRenderer(this),B=x},this.dispose=function(){e.removeEventListener("webglcontextlost",bt,!1),e.removeEventListener("webglcontextrestored",Ut,!1),e.removeEventListener("webglcontextcreationerror",dt,!1),R.dispose(),ct.dispose(),q.dispose(),Lt.dispose(),At.dispose(),b.dispose(),et.dispose(),F.dispose(),rt.dispose(),Et.dispose(),J.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",Xl),nt.removeEventListener("sessionend",ql),fi.stop()};function bt(x){x.preventDefault(),Jc("WebGLRenderer: Context Lost."),D=!0}function Ut(){Jc("WebGLRenderer: Context Restored."),D=!1;const x=Me.autoReset,P=at.enabled,z=at.autoUpdate,U=at.needsUpdate,k=at.type;Ft(),Me.autoReset=x,at.enabled=P,at.autoUpdate=z,at.needsUpdate=U,at.type=k}function dt(x){Qt("WebGLRenderer: A WebGL context could not be created. Reason: ",x.statusMessage)}function ee(x){const P=x.target;P.removeEventListener("dispose",ee),be(P)}function be(x){Kn(x),At.remove(x)}function Kn(x){const P=At.get(x).programs;P!==void 0&&(P.forEach(function(z){J.releaseProgram(z)}),x.isShaderMaterial&&J.releaseShaderCache(x))}this.renderBufferDirect=function(x,P,z,U,k,ht){P===null&&(P=Ke);const _t=k.isMesh&&k.matrixWorld.determinantAffine()<0,lt=zd(x,P,z,U,k);ut.setMaterial(U,_t);let gt=z.index,wt=1;if(U.wireframe===!0){if(gt=F.getWireframeAttribute(z),gt===void 0)return;wt=2}const Dt=z.drawRange,Ht=z.attributes.position;let xt=Dt.start*wt,Vt=(Dt.start+Dt.count)*wt;ht!==null&&(xt=Math.max(xt,ht.start*wt),Vt=Math.min(Vt,(ht.start+ht.count)*wt)),gt!==null?(xt=Math.max(xt,0),Vt=Math.min(Vt,gt.count)):Ht!=null&&(xt=Math.max(xt,0),Vt=Math.min(Vt,Ht.count));const ge=Vt-xt;if(ge<0||ge===1/0)return;rt.setup(k,U,lt,z,gt);let re,se=W;if(gt!==null&&(re=v.get(gt),se=ot,se.setIndex(re)),k.isMesh)U.wireframe===!0?(ut.setLineWidth(U.wireframeLinewidth*Je()),se.setMode(I.LINES)):se.setMode(I.TRIANGLES);else if(k.isLine){let Ie=U.linewidth;Ie===void 0&&(Ie=1),ut.setLineWidth(Ie*Je()),k.isLineSegments?se.setMode(I.LINES):k.isLineLoop?se.setMode(I.LINE_LOOP):se.setMode(I.LINE_STRIP)}else k.isPoints?se.setMode(I.POINTS):k.isSprite&&se.setMode(I.TRIANGLES);if(k.isBatchedMesh)if(oe.get("WEBGL_multi_draw"))se.renderMultiDraw(k._multiDrawStarts,k._multiDrawCounts,k._multiDrawCount);else{const Ie=k._multiDrawStarts,St=k._multiDrawCounts,Oe=k._multiDrawCount,Jt=gt?v.get(gt).bytesPerElement:1,pi=At.get(U).currentProgram.getUniforms();for(let De=0;De<Oe;De++)pi.setValue(I,"_gl_DrawID",De),se.render(Ie[De]/Jt,St[De])}else if(k.isInstancedMesh)se.renderInstances(xt,ge,k.count);else if(z.isInstancedBufferGeometry){const Ie=z._maxInstanceCount!==void 0?z._maxInstanceCount:1/0,St=Math.min(z.instanceCount,Ie);se.renderInstances(xt,ge,St)}else se.render(xt,ge)};function Wl(x,P,z,U){B!==null&&x.isNodeMaterial&&B.setObject(U,x),Se===!0&&Y.setState(x,z,!1),x.transparent===!0&&x.side===bn&&x.forceSinglePass===!1?(x.side=Ve,x.needsUpdate=!0,rs(x,P,U),x.side=ci,x.needsUpdate=!0,rs(x,P,U),x.side=bn):rs(x,P,U)}this.compile=function(x,P,z=null){z===null&&(z=x),B!==null&&B.renderStart(x,P,z),E=q.get(z),E.init(P),w.push(E),z.traverseVisible(function(k){k.isLight&&k.layers.test(P.layers)&&(E.pushLight(k),k.castShadow&&E.pushShadow(k))}),x!==z&&x.traverseVisible(function(k){k.isLight&&k.layers.test(P.layers)&&(E.pushLight(k),k.castShadow&&E.pushShadow(k))}),E.setupLights(),B!==null&&B.updateLights(E.state.lightsArray),Ge=this.localClippingEnabled,Se=Y.init(this.clippingPlanes,Ge),Se===!0&&Y.setGlobalState(this.clippingPlanes,P),B!==null&&at.render(E.state.shadowsArray,z,P);const U=new Set;return x.traverse(function(k){if(!(k.isMesh||k.isPoints||k.isLine||k.isSprite))return;const ht=k.material;if(ht)if(Array.isArray(ht))for(let _t=0;_t<ht.length;_t++){const lt=ht[_t];Wl(lt,z,P,k),U.add(lt)}else Wl(ht,z,P,k),U.add(ht)}),E=w.pop(),B!==null&&B.renderEnd(),U},this.compileAsync=function(x,P,z=null){const U=this.compile(x,P,z);return new Promise(k=>{function ht(){if(U.forEach(function(_t){const gt=At.get(_t).currentProgram;(gt===void 0||gt.isReady())&&U.delete(_t)}),U.size===0){k(x);return}setTimeout(ht,10)}oe.get("KHR_parallel_shader_compile")!==null?ht():setTimeout(ht,10)})};let aa=null;function kd(x){aa&&aa(x)}function Xl(){fi.stop()}function ql(){fi.start()}const fi=new od;fi.setAnimationLoop(kd),typeof self<"u"&&fi.setContext(self),this.setAnimationLoop=function(x){aa=x,nt.setAnimationLoop(x),x===null?fi.stop():fi.start()},nt.addEventListener("sessionstart",Xl),nt.addEventListener("sessionend",ql),this.render=function(x,P){if(P!==void 0&&P.isCamera!==!0){Qt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;B!==null&&B.renderStart(x,P);const z=nt.enabled===!0&&nt.isPresenting===!0,U=N!==null&&(tt===null||z)&&N.begin(C,tt);if(x.matrixWorldAutoUpdate===!0&&x.updateMatrixWorld(),P.parent===null&&P.matrixWorldAutoUpdate===!0&&P.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(P),P=nt.getCamera()),x.isScene===!0&&x.onBeforeRender(C,x,P,tt),E=q.get(x,w.length),E.init(P),E.state.textureUnits=Lt.getTextureUnits(),w.push(E),he.multiplyMatrices(P.projectionMatrix,P.matrixWorldInverse),P.isArrayCamera?Le.setFromArrayCamera(P):Gt.setFromProjectionMatrix(he,pn,P.reversedDepth),Ge=this.localClippingEnabled,Se=Y.init(this.clippingPlanes,Ge),A=ct.get(x,g.length),A.init(),g.push(A),this.info.render.frame++,nt.enabled===!0&&nt.isPresenting===!0){const _t=C.xr.getDepthSensingMesh();_t!==null&&oa(_t,P,-1/0,C.sortObjects)}oa(x,P,0,C.sortObjects),A.finish(),B!==null&&B.updateLights(E.state.lightsArray),C.sortObjects===!0&&A.sort(Nt,me),Ze=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,Ze&&R.addToRenderList(A,x),this.info.autoReset===!0&&this.info.reset(),Se===!0&&Y.beginShadows();const k=E.state.shadowsArray;if(at.render(k,x,P),Se===!0&&Y.endShadows(),(U&&N.hasRenderPass())===!1){const _t=A.opaque,lt=A.transmissive;if(E.setupLights(),P.isArrayCamera){const gt=P.cameras;if(lt.length>0)for(let wt=0,Dt=gt.length;wt<Dt;wt++){const Ht=gt[wt];Yl(_t,lt,x,Ht)}Ze&&R.render(x);for(let wt=0,Dt=gt.length;wt<Dt;wt++){const Ht=gt[wt];$l(A,x,Ht,Ht.viewport)}}else lt.length>0&&Yl(_t,lt,x,P),Ze&&R.render(x),$l(A,x,P)}tt!==null&&G===0&&(Lt.updateMultisampleRenderTarget(tt),Lt.updateRenderTargetMipmap(tt)),U&&N.end(C),x.isScene===!0&&x.onAfterRender(C,x,P),rt.resetDefaultState(),X=-1,Q=null,w.pop(),w.length>0?(E=w[w.length-1],Lt.setTextureUnits(E.state.textureUnits),Se===!0&&Y.setGlobalState(C.clippingPlanes,E.state.camera)):E=null,g.pop(),g.length>0?A=g[g.length-1]:A=null,B!==null&&B.renderEnd()};function oa(x,P,z,U){if(x.visible===!1)return;if(x.layers.test(P.layers)){if(x.isGroup)z=x.renderOrder;else if(x.isLOD)x.autoUpdate===!0&&x.update(P);else if(x.isLight)E.pushLight(x),x.castShadow&&E.pushShadow(x);else if(x.isSprite){const _t=P.isArrayCamera?Le:Gt;if(!x.frustumCulled||x.intersectsFrustum(_t)){U&&Ee.setFromMatrixPosition(x.matrixWorld).applyMatrix4(he);const lt=et.update(x),gt=x.material;gt.visible&&A.push(x,lt,gt,z,Ee.z,null,P)}}else if(x.isMesh||x.isLine||x.isPoints){const _t=P.isArrayCamera?Le:Gt;if(!x.frustumCulled||x.intersectsFrustum(_t)){const lt=et.update(x),gt=x.material;if(U&&(x.boundingSphere!==void 0?(x.boundingSphere===null&&x.computeBoundingSphere(),Ee.copy(x.boundingSphere.center)):(lt.boundingSphere===null&&lt.computeBoundingSphere(),Ee.copy(lt.boundingSphere.center)),Ee.applyMatrix4(x.matrixWorld).applyMatrix4(he)),Array.isArray(gt)){const wt=lt.groups;for(let Dt=0,Ht=wt.length;Dt<Ht;Dt++){const xt=wt[Dt],Vt=gt[xt.materialIndex];Vt&&Vt.visible&&A.push(x,lt,Vt,z,Ee.z,xt,P)}}else gt.visible&&A.push(x,lt,gt,z,Ee.z,null,P)}}}const ht=x.children;for(let _t=0,lt=ht.length;_t<lt;_t++)oa(ht[_t],P,z,U)}function $l(x,P,z,U){const{opaque:k,transmissive:ht,transparent:_t}=x;E.setupLightsView(z),Se===!0&&Y.setGlobalState(C.clippingPlanes,z),U&&ut.viewport(j.copy(U)),k.length>0&&zs(k,P,z),ht.length>0&&zs(ht,P,z),_t.length>0&&zs(_t,P,z),ut.buffers.depth.setTest(!0),ut.buffers.depth.setMask(!0),ut.buffers.color.setMask(!0),ut.setPolygonOffset(!1)}function Yl(x,P,z,U){if((z.isScene===!0?z.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[U.id]===void 0){const xt=oe.has("EXT_color_buffer_half_float")||oe.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[U.id]=new mn(1,1,{generateMipmaps:!0,type:xt?gn:en,minFilter:oi,samples:Math.max(4,le.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:$t.workingColorSpace})}const ht=E.state.transmissionRenderTarget[U.id],_t=U.viewport||j;ht.setSize(_t.z*C.transmissionResolutionScale,_t.w*C.transmissionResolutionScale);const lt=C.getRenderTarget(),gt=C.getActiveCubeFace(),wt=C.getActiveMipmapLevel();C.setRenderTarget(ht),C.getClearColor(K),pt=C.getClearAlpha(),pt<1&&C.setClearColor(16777215,.5),C.clear(),Ze&&R.render(z);const Dt=C.toneMapping;C.toneMapping=Vn;const Ht=U.viewport;if(U.viewport!==void 0&&(U.viewport=void 0),E.setupLightsView(U),Se===!0&&Y.setGlobalState(C.clippingPlanes,U),zs(x,z,U),Lt.updateMultisampleRenderTarget(ht),Lt.updateRenderTargetMipmap(ht),oe.has("WEBGL_multisampled_render_to_texture")===!1){let xt=!1;for(let Vt=0,ge=P.length;Vt<ge;Vt++){const re=P[Vt],{object:se,geometry:Ie,material:St,group:Oe}=re;if(St.side===bn&&se.layers.test(U.layers)){const Jt=St.side;St.side=Ve,St.needsUpdate=!0,Kl(se,z,U,Ie,St,Oe),St.side=Jt,St.needsUpdate=!0,xt=!0}}xt===!0&&(Lt.updateMultisampleRenderTarget(ht),Lt.updateRenderTargetMipmap(ht))}C.setRenderTarget(lt,gt,wt),C.setClearColor(K,pt),Ht!==void 0&&(U.viewport=Ht),C.toneMapping=Dt}function zs(x,P,z){const U=P.isScene===!0?P.overrideMaterial:null;for(let k=0,ht=x.length;k<ht;k++){const _t=x[k],{object:lt,geometry:gt,group:wt}=_t;let Dt=_t.material;Dt.allowOverride===!0&&U!==null&&(Dt=U),lt.layers.test(z.layers)&&Kl(lt,P,z,gt,Dt,wt)}}function Kl(x,P,z,U,k,ht){B!==null&&k.isNodeMaterial&&B.setObject(x,k),x.onBeforeRender(C,P,z,U,k,ht),x.modelViewMatrix.multiplyMatrices(z.matrixWorldInverse,x.matrixWorld),x.normalMatrix.getNormalMatrix(x.modelViewMatrix),k.onBeforeRender(C,P,z,U,x,ht),k.transparent===!0&&k.side===bn&&k.forceSinglePass===!1?(k.side=Ve,k.needsUpdate=!0,C.renderBufferDirect(z,P,U,k,x,ht),k.side=ci,k.needsUpdate=!0,C.renderBufferDirect(z,P,U,k,x,ht),k.side=bn):C.renderBufferDirect(z,P,U,k,x,ht),x.onAfterRender(C,P,z,U,k,ht)}function Zl(x){let P=0;for(const z of x)z.texture!==null&&P++;return P}function rs(x,P,z){P.isScene!==!0&&(P=Ke);const U=At.get(x),k=E.state.lights,ht=E.state.shadowsArray,_t=k.state.version,lt=J.getParameters(x,k.state,ht,P,z,E.state.lightProbeGridArray),gt=J.getProgramCacheKey(lt);let wt=U.programs;U.environment=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?P.environment:null,U.fog=P.fog;const Dt=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap;U.envMap=b.get(x.envMap||U.environment,Dt),U.envMapRotation=U.environment!==null&&x.envMap===null?P.environmentRotation:x.envMapRotation,wt===void 0&&(x.addEventListener("dispose",ee),wt=new Map,U.programs=wt,U.programVariants=new Map);let Ht=wt.get(gt);if(Ht!==void 0){if(U.currentProgram===Ht&&U.lightsStateVersion===_t)return Ql(x,lt),Ht}else lt.uniforms=J.getUniforms(x),B!==null&&x.isNodeMaterial&&B.build(x,z,lt),x.onBeforeCompile(lt,C),Ht=J.acquireProgram(lt,gt),wt.set(gt,Ht),U.uniforms=lt.uniforms;const xt=U.uniforms;return(!x.isShaderMaterial&&!x.isRawShaderMaterial||x.clipping===!0)&&(xt.clippingPlanes=Y.uniform),Ql(x,lt),U.needsLights=Hd(x),U.lightsStateVersion=_t,U.needsLights&&(xt.ambientLightColor.value=k.state.ambient,xt.lightProbe.value=k.state.probe,xt.sunLights.value=k.state.sun,xt.sunLightShadows.value=k.state.sunShadow,xt.directionalLights.value=k.state.directional,xt.directionalLightShadows.value=k.state.directionalShadow,xt.spotLights.value=k.state.spot,xt.spotLightShadows.value=k.state.spotShadow,xt.rectAreaLights.value=k.state.rectArea,xt.ltc_1.value=k.state.rectAreaLTC1,xt.ltc_2.value=k.state.rectAreaLTC2,xt.pointLights.value=k.state.point,xt.pointLightShadows.value=k.state.pointShadow,xt.hemisphereLights.value=k.state.hemi,xt.sunShadowMatrix.value=k.state.sunShadowMatrix,xt.sunShadowCascade.value=k.state.sunShadowCascade,xt.directionalShadowMatrix.value=k.state.directionalShadowMatrix,xt.spotLightMatrix.value=k.state.spotLightMatrix,xt.spotLightMap.value=k.state.spotLightMap,xt.pointShadowMatrix.value=k.state.pointShadowMatrix),U.numLightProbeGrids=Zl(E.state.lightProbeGridArray),U.currentProgram=Ht,U.uniformsList=null,Ht}function Bd(x,P,z,U,k){const ht=At.get(x),_t=ht.currentProgram.id+","+U+","+k;let lt=ht.programVariants.get(_t);return lt===void 0?(lt=rs(x,P,z),ht.programVariants.set(_t,lt)):(ht.currentProgram=lt,ht.uniformsList=null,ht.outputColorSpace=U,ht.toneMapping=k),lt}function Jl(x){if(x.uniformsList===null){const P=x.currentProgram.getUniforms();x.uniformsList=Nr.seqWithValue(P.seq,x.uniforms)}return x.uniformsList}function Ql(x,P){const z=At.get(x);z.outputColorSpace=P.outputColorSpace,z.batching=P.batching,z.batchingColor=P.batchingColor,z.instancing=P.instancing,z.instancingColor=P.instancingColor,z.instancingMorph=P.instancingMorph,z.skinning=P.skinning,z.morphTargets=P.morphTargets,z.morphNormals=P.morphNormals,z.morphColors=P.morphColors,z.morphTargetsCount=P.morphTargetsCount,z.numClippingPlanes=P.numClippingPlanes,z.numIntersection=P.numClipIntersection,z.vertexAlphas=P.vertexAlphas,z.vertexTangents=P.vertexTangents,z.toneMapping=P.toneMapping}function zd(x,P,z,U,k){P.isScene!==!0&&(P=Ke),Lt.resetTextureUnits();const ht=P.fog,_t=U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial?P.environment:null,lt=tt===null?C.outputColorSpace:tt.isXRRenderTarget===!0?tt.texture.colorSpace:$t.workingColorSpace,gt=U.isMeshStandardMaterial||U.isMeshLambertMaterial&&!U.envMap||U.isMeshPhongMaterial&&!U.envMap,wt=b.get(U.envMap||_t,gt),Dt=U.vertexColors===!0&&!!z.attributes.color&&z.attributes.color.itemSize===4,Ht=!!z.attributes.tangent&&(!!U.normalMap||U.anisotropy>0),xt=!!z.morphAttributes.position,Vt=!!z.morphAttributes.normal,ge=!!z.morphAttributes.color;let re=Vn;U.toneMapped&&(tt===null||tt.isXRRenderTarget===!0)&&(re=C.toneMapping);const se=z.morphAttributes.position||z.morphAttributes.normal||z.morphAttributes.color,Ie=se!==void 0?se.length:0,St=At.get(U),Oe=E.state.lights;if(Se===!0&&(Ge===!0||x!==Q)){const ue=x===Q&&U.id===X;Y.setState(U,x,ue)}let Jt=!1,pi=!1;U.version===St.__version?St.needsLights&&St.lightsStateVersion!==Oe.state.version||k.isBatchedMesh&&St.batching===!1||!k.isBatchedMesh&&St.batching===!0||k.isBatchedMesh&&St.batchingColor===!0&&k._colorsTexture===null||k.isBatchedMesh&&St.batchingColor===!1&&k._colorsTexture!==null||k.isInstancedMesh&&St.instancing===!1||!k.isInstancedMesh&&St.instancing===!0||k.isSkinnedMesh&&St.skinning===!1||!k.isSkinnedMesh&&St.skinning===!0||k.isInstancedMesh&&St.instancingColor===!0&&k.instanceColor===null||k.isInstancedMesh&&St.instancingColor===!1&&k.instanceColor!==null||k.isInstancedMesh&&St.instancingMorph===!0&&k.morphTexture===null||k.isInstancedMesh&&St.instancingMorph===!1&&k.morphTexture!==null||St.envMap!==wt||U.fog===!0&&St.fog!==ht||St.numClippingPlanes!==void 0&&(St.numClippingPlanes!==Y.numPlanes||St.numIntersection!==Y.numIntersection)||St.vertexAlphas!==Dt||St.vertexTangents!==Ht||St.morphTargets!==xt||St.morphNormals!==Vt||St.morphColors!==ge||St.morphTargetsCount!==Ie||St.numLightProbeGrids!==Zl(E.state.lightProbeGridArray)?Jt=!0:(St.outputColorSpace!==lt||St.toneMapping!==re)&&(pi=!0):(Jt=!0,St.__version=U.version);let De=St.currentProgram;(Jt===!0||pi===!0)&&(De=pi===!0?Bd(U,P,k,lt,re):rs(U,P,k),B&&U.isNodeMaterial&&B.onUpdateProgram(U,De,St));let Gs=!1,Zn=!1,mi=!1;const Kt=De.getUniforms(),Pe=St.uniforms;if(ut.useProgram(De.program)&&(Gs=!0,Zn=!0,mi=!0),U.id!==X&&(X=U.id,Zn=!0),Gs||Q!==x){ut.buffers.depth.getReversed()&&x.reversedDepth!==!0&&(x._reversedDepth=!0,x.updateProjectionMatrix()),Kt.setValue(I,"projectionMatrix",x.projectionMatrix),Kt.setValue(I,"viewMatrix",x.matrixWorldInverse);const Te=Kt.map.cameraPosition;Te!==void 0&&Te.setValue(I,_n.setFromMatrixPosition(x.matrixWorld)),le.logarithmicDepthBuffer&&Kt.setValue(I,"logDepthBufFC",2/(Math.log(x.far+1)/Math.LN2)),(U.isMeshPhongMaterial||U.isMeshToonMaterial||U.isMeshLambertMaterial||U.isMeshBasicMaterial||U.isMeshStandardMaterial||U.isShaderMaterial)&&Kt.setValue(I,"isOrthographic",x.isOrthographicCamera===!0),Q!==x&&(Q=x,Zn=!0,mi=!0)}if(St.needsLights&&(Oe.state.sunShadowMap.length>0&&Kt.setValue(I,"sunShadowMap",Oe.state.sunShadowMap,Lt),Oe.state.directionalShadowMap.length>0&&Kt.setValue(I,"directionalShadowMap",Oe.state.directionalShadowMap,Lt),Oe.state.spotShadowMap.length>0&&Kt.setValue(I,"spotShadowMap",Oe.state.spotShadowMap,Lt),Oe.state.pointShadowMap.length>0&&Kt.setValue(I,"pointShadowMap",Oe.state.pointShadowMap,Lt)),k.isSkinnedMesh){Kt.setOptional(I,k,"bindMatrix"),Kt.setOptional(I,k,"bindMatrixInverse");const ue=k.skeleton;ue&&(ue.boneTexture===null&&ue.computeBoneTexture(),Kt.setValue(I,"boneTexture",ue.boneTexture,Lt))}k.isBatchedMesh&&(Kt.setOptional(I,k,"batchingTexture"),Kt.setValue(I,"batchingTexture",k._matricesTexture,Lt),Kt.setOptional(I,k,"batchingIdTexture"),Kt.setValue(I,"batchingIdTexture",k._indirectTexture,Lt),Kt.setOptional(I,k,"batchingColorTexture"),k._colorsTexture!==null&&Kt.setValue(I,"batchingColorTexture",k._colorsTexture,Lt));const on=z.morphAttributes;if((on.position!==void 0||on.normal!==void 0||on.color!==void 0)&&Z.update(k,z,De),(Zn||St.receiveShadow!==k.receiveShadow)&&(St.receiveShadow=k.receiveShadow,Kt.setValue(I,"receiveShadow",k.receiveShadow)),(U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial)&&U.envMap===null&&P.environment!==null&&(Pe.envMapIntensity.value=P.environmentIntensity),Pe.dfgLUT!==void 0&&(Pe.dfgLUT.value=yS()),Zn){if(Kt.setValue(I,"toneMappingExposure",C.toneMappingExposure),St.needsLights&&Gd(Pe,mi),ht&&U.fog===!0&&st.refreshFogUniforms(Pe,ht),st.refreshMaterialUniforms(Pe,U,mt,Tt,E.state.transmissionRenderTarget[x.id]),St.needsLights&&St.numLightProbeGrids>0){const ue=M;let Te=0;for(const Ln of E.state.lightProbeGridArray)Ln.texture!==null&&(ue.textures[Te]=Ln.texture,ue.min[Te]=Ln.boundingBox.min,ue.max[Te]=Ln.boundingBox.max,ue.resolution[Te]=Ln.resolution,Te++);for(const Ln in ue)ue[Ln].length=Te;Pe.probesSH.value=ue.textures,Pe.probesMin.value=ue.min,Pe.probesMax.value=ue.max,Pe.probesResolution.value=ue.resolution}Nr.upload(I,Jl(St),Pe,Lt)}if(U.isShaderMaterial&&U.uniformsNeedUpdate===!0&&(Nr.upload(I,Jl(St),Pe,Lt),U.uniformsNeedUpdate=!1),U.isSpriteMaterial&&Kt.setValue(I,"center",k.center),Kt.setValue(I,"modelViewMatrix",k.modelViewMatrix),Kt.setValue(I,"normalMatrix",k.normalMatrix),Kt.setValue(I,"modelMatrix",k.matrixWorld),U.uniformsGroups!==void 0){const ue=U.uniformsGroups;for(let Te=0,Ln=ue.length;Te<Ln;Te++){const tc=ue[Te];Et.update(tc,De),Et.bind(tc,De)}}return De}function Gd(x,P){x.ambientLightColor.needsUpdate=P,x.lightProbe.needsUpdate=P,x.sunLights.needsUpdate=P,x.sunLightShadows.needsUpdate=P,x.directionalLights.needsUpdate=P,x.directionalLightShadows.needsUpdate=P,x.pointLights.needsUpdate=P,x.pointLightShadows.needsUpdate=P,x.spotLights.needsUpdate=P,x.spotLightShadows.needsUpdate=P,x.rectAreaLights.needsUpdate=P,x.hemisphereLights.needsUpdate=P}function Hd(x){return x.isMeshLambertMaterial||x.isMeshToonMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isShadowMaterial||x.isShaderMaterial&&x.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return tt},this.setRenderTargetTextures=function(x,P,z){const U=At.get(x);U.__autoAllocateDepthBuffer=x.resolveDepthBuffer===!1,U.__autoAllocateDepthBuffer===!1&&(U.__useRenderToTexture=!1),At.get(x.texture).__webglTexture=P,At.get(x.depthTexture).__webglTexture=U.__autoAllocateDepthBuffer?void 0:z,U.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(x,P){const z=At.get(x);z.__webglFramebuffer=P,z.__useDefaultFramebuffer=P===void 0},this.setRenderTarget=function(x,P=0,z=0){tt=x,$=P,G=z;let U=null,k=!1,ht=!1;if(x){const lt=At.get(x);if(lt.__useDefaultFramebuffer!==void 0){ut.bindFramebuffer(I.FRAMEBUFFER,lt.__webglFramebuffer),j.copy(x.viewport),yt.copy(x.scissor),It=x.scissorTest,ut.viewport(j),ut.scissor(yt),ut.setScissorTest(It),X=-1;return}else if(lt.__webglFramebuffer===void 0)Lt.setupRenderTarget(x);else if(lt.__hasExternalTextures)Lt.rebindTextures(x,At.get(x.texture).__webglTexture,At.get(x.depthTexture).__webglTexture);else if(x.depthBuffer){const Dt=x.depthTexture;if(lt.__boundDepthTexture!==Dt){if(Dt!==null&&At.has(Dt)&&(x.width!==Dt.image.width||x.height!==Dt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Lt.setupDepthRenderbuffer(x)}}const gt=x.texture;(gt.isData3DTexture||gt.isDataArrayTexture||gt.isCompressedArrayTexture)&&(ht=!0);const wt=At.get(x).__webglFramebuffer;x.isWebGLCubeRenderTarget?(Array.isArray(wt[P])?U=wt[P][z]:U=wt[P],k=!0):x.samples>0&&Lt.useMultisampledRTT(x)===!1?U=At.get(x).__webglMultisampledFramebuffer:Array.isArray(wt)?U=wt[z]:U=wt,j.copy(x.viewport),yt.copy(x.scissor),It=x.scissorTest}else j.copy(Rt).multiplyScalar(mt).floor(),yt.copy(te).multiplyScalar(mt).floor(),It=ie;if(z!==0&&(U=V),ut.bindFramebuffer(I.FRAMEBUFFER,U)&&ut.drawBuffers(x,U),ut.viewport(j),ut.scissor(yt),ut.setScissorTest(It),k){const lt=At.get(x.texture);I.framebufferTexture2D(I.FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_CUBE_MAP_POSITIVE_X+P,lt.__webglTexture,z)}else if(ht){const lt=P;for(let gt=0;gt<x.textures.length;gt++){const wt=At.get(x.textures[gt]);I.framebufferTextureLayer(I.FRAMEBUFFER,I.COLOR_ATTACHMENT0+gt,wt.__webglTexture,z,lt)}}else if(x!==null&&z!==0){const lt=At.get(x.texture);I.framebufferTexture2D(I.FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_2D,lt.__webglTexture,z)}X=-1};function jl(x){const P=At.get(x);return(P.__readFormat!==x.format||P.__readType!==x.type)&&(P.__readFormat=x.format,P.__readType=x.type,P.__formatReadable=le.textureFormatReadable(x.format),P.__typeReadable=le.textureTypeReadable(x.type)),P}this.readRenderTargetPixels=function(x,P,z,U,k,ht,_t,lt=0){if(!(x&&x.isWebGLRenderTarget)){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let gt=At.get(x).__webglFramebuffer;if(x.isWebGLCubeRenderTarget&&_t!==void 0&&(gt=gt[_t],Array.isArray(gt)&&(gt=gt[0])),gt){ut.bindFramebuffer(I.FRAMEBUFFER,gt);try{const wt=x.textures[lt],Dt=wt.format,Ht=wt.type;x.textures.length>1&&I.readBuffer(I.COLOR_ATTACHMENT0+lt);const xt=jl(wt);if(xt.__formatReadable===!1){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(xt.__typeReadable===!1){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}P>=0&&P<=x.width-U&&z>=0&&z<=x.height-k&&I.readPixels(P,z,U,k,it.convert(Dt),it.convert(Ht),ht)}finally{const wt=tt!==null?At.get(tt).__webglFramebuffer:null;ut.bindFramebuffer(I.FRAMEBUFFER,wt)}}},this.readRenderTargetPixelsAsync=async function(x,P,z,U,k,ht,_t,lt=0){if(!(x&&x.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let gt=At.get(x).__webglFramebuffer;if(x.isWebGLCubeRenderTarget&&_t!==void 0&&(gt=gt[_t],Array.isArray(gt)&&(gt=gt[0])),gt)if(P>=0&&P<=x.width-U&&z>=0&&z<=x.height-k){ut.bindFramebuffer(I.FRAMEBUFFER,gt);const wt=x.textures[lt],Dt=wt.format,Ht=wt.type;x.textures.length>1&&I.readBuffer(I.COLOR_ATTACHMENT0+lt);const xt=jl(wt);if(xt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(xt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");const Vt=I.createBuffer();I.bindBuffer(I.PIXEL_PACK_BUFFER,Vt),I.bufferData(I.PIXEL_PACK_BUFFER,ht.byteLength,I.STREAM_READ),I.readPixels(P,z,U,k,it.convert(Dt),it.convert(Ht),0),I.bindBuffer(I.PIXEL_PACK_BUFFER,null);const ge=tt!==null?At.get(tt).__webglFramebuffer:null;ut.bindFramebuffer(I.FRAMEBUFFER,ge);const re=I.fenceSync(I.SYNC_GPU_COMMANDS_COMPLETE,0);return I.flush(),await Wm(I,re,4),I.bindBuffer(I.PIXEL_PACK_BUFFER,Vt),I.getBufferSubData(I.PIXEL_PACK_BUFFER,0,ht),I.bindBuffer(I.PIXEL_PACK_BUFFER,null),I.deleteBuffer(Vt),I.deleteSync(re),ht}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(x,P=null,z=0){const U=Math.pow(2,-z),k=Math.floor(x.image.width*U),ht=Math.floor(x.image.height*U),_t=P!==null?P.x:0,lt=P!==null?P.y:0;Lt.setTexture2D(x,0),I.copyTexSubImage2D(I.TEXTURE_2D,z,0,0,_t,lt,k,ht),ut.unbindTexture()},this.copyTextureToTexture=function(x,P,z=null,U=null,k=0,ht=0){let _t,lt,gt,wt,Dt,Ht,xt,Vt,ge;const re=x.isCompressedTexture?x.mipmaps[ht]:x.image;if(z!==null)_t=z.max.x-z.min.x,lt=z.max.y-z.min.y,gt=z.isBox3?z.max.z-z.min.z:1,wt=z.min.x,Dt=z.min.y,Ht=z.isBox3?z.min.z:0;else{const Kt=Math.pow(2,-k);_t=Math.floor(re.width*Kt),lt=Math.floor(re.height*Kt),x.isDataArrayTexture?gt=re.depth:x.isData3DTexture?gt=Math.floor(re.depth*Kt):gt=1,wt=0,Dt=0,Ht=0}U!==null?(xt=U.x,Vt=U.y,ge=U.z):(xt=0,Vt=0,ge=0);const se=it.convert(P.format),Ie=it.convert(P.type);let St;P.isData3DTexture?(Lt.setTexture3D(P,0),St=I.TEXTURE_3D):P.isDataArrayTexture||P.isCompressedArrayTexture?(Lt.setTexture2DArray(P,0),St=I.TEXTURE_2D_ARRAY):(Lt.setTexture2D(P,0),St=I.TEXTURE_2D),ut.activeTexture(I.TEXTURE0),ut.pixelStorei(I.UNPACK_FLIP_Y_WEBGL,P.flipY),ut.pixelStorei(I.UNPACK_PREMULTIPLY_ALPHA_WEBGL,P.premultiplyAlpha),ut.pixelStorei(I.UNPACK_ALIGNMENT,P.unpackAlignment);const Oe=ut.getParameter(I.UNPACK_ROW_LENGTH),Jt=ut.getParameter(I.UNPACK_IMAGE_HEIGHT),pi=ut.getParameter(I.UNPACK_SKIP_PIXELS),De=ut.getParameter(I.UNPACK_SKIP_ROWS),Gs=ut.getParameter(I.UNPACK_SKIP_IMAGES);ut.pixelStorei(I.UNPACK_ROW_LENGTH,re.width),ut.pixelStorei(I.UNPACK_IMAGE_HEIGHT,re.height),ut.pixelStorei(I.UNPACK_SKIP_PIXELS,wt),ut.pixelStorei(I.UNPACK_SKIP_ROWS,Dt),ut.pixelStorei(I.UNPACK_SKIP_IMAGES,Ht);const Zn=x.isDataArrayTexture||x.isData3DTexture,mi=P.isDataArrayTexture||P.isData3DTexture;if(x.isDepthTexture){const Kt=At.get(x),Pe=At.get(P),on=At.get(Kt.__renderTarget),ue=At.get(Pe.__renderTarget);ut.bindFramebuffer(I.READ_FRAMEBUFFER,on.__webglFramebuffer),ut.bindFramebuffer(I.DRAW_FRAMEBUFFER,ue.__webglFramebuffer);for(let Te=0;Te<gt;Te++)Zn&&(I.framebufferTextureLayer(I.READ_FRAMEBUFFER,I.COLOR_ATTACHMENT0,At.get(x).__webglTexture,k,Ht+Te),I.framebufferTextureLayer(I.DRAW_FRAMEBUFFER,I.COLOR_ATTACHMENT0,At.get(P).__webglTexture,ht,ge+Te)),I.blitFramebuffer(wt,Dt,wt+_t,Dt+lt,xt,Vt,xt+_t,Vt+lt,I.DEPTH_BUFFER_BIT,I.NEAREST);ut.bindFramebuffer(I.READ_FRAMEBUFFER,null),ut.bindFramebuffer(I.DRAW_FRAMEBUFFER,null)}else if(k!==0||x.isRenderTargetTexture||At.has(x)){const Kt=At.get(x),Pe=At.get(P);ut.bindFramebuffer(I.READ_FRAMEBUFFER,L),ut.bindFramebuffer(I.DRAW_FRAMEBUFFER,H);for(let on=0;on<gt;on++)Zn?I.framebufferTextureLayer(I.READ_FRAMEBUFFER,I.COLOR_ATTACHMENT0,Kt.__webglTexture,k,Ht+on):I.framebufferTexture2D(I.READ_FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_2D,Kt.__webglTexture,k),mi?I.framebufferTextureLayer(I.DRAW_FRAMEBUFFER,I.COLOR_ATTACHMENT0,Pe.__webglTexture,ht,ge+on):I.framebufferTexture2D(I.DRAW_FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_2D,Pe.__webglTexture,ht),k!==0?I.blitFramebuffer(wt,Dt,wt+_t,Dt+lt,xt,Vt,xt+_t,Vt+lt,I.COLOR_BUFFER_BIT,I.NEAREST):mi?I.copyTexSubImage3D(St,ht,xt,Vt,ge+on,wt,Dt,_t,lt):I.copyTexSubImage2D(St,ht,xt,Vt,wt,Dt,_t,lt);ut.bindFramebuffer(I.READ_FRAMEBUFFER,null),ut.bindFramebuffer(I.DRAW_FRAMEBUFFER,null)}else mi?x.isDataTexture||x.isData3DTexture?I.texSubImage3D(St,ht,xt,Vt,ge,_t,lt,gt,se,Ie,re.data):P.isCompressedArrayTexture?I.compressedTexSubImage3D(St,ht,xt,Vt,ge,_t,lt,gt,se,re.data):I.texSubImage3D(St,ht,xt,Vt,ge,_t,lt,gt,se,Ie,re):x.isDataTexture?I.texSubImage2D(I.TEXTURE_2D,ht,xt,Vt,_t,lt,se,Ie,re.data):x.isCompressedTexture?I.compressedTexSubImage2D(I.TEXTURE_2D,ht,xt,Vt,re.width,re.height,se,re.data):I.texSubImage2D(I.TEXTURE_2D,ht,xt,Vt,_t,lt,se,Ie,re);ut.pixelStorei(I.UNPACK_ROW_LENGTH,Oe),ut.pixelStorei(I.UNPACK_IMAGE_HEIGHT,Jt),ut.pixelStorei(I.UNPACK_SKIP_PIXELS,pi),ut.pixelStorei(I.UNPACK_SKIP_ROWS,De),ut.pixelStorei(I.UNPACK_SKIP_IMAGES,Gs),ht===0&&P.generateMipmaps===!0&&P.mipmapsAutoUpdate===!0&&I.generateMipmap(St),ut.unbindTexture()},this.initRenderTarget=function(x){At.get(x).__webglFramebuffer===void 0&&Lt.setupRenderTarget(x)},this.initTexture=function(x){x.isCubeTexture?Lt.setTextureCube(x,0):x.isData3DTexture?Lt.setTexture3D(x,0):x.isDataArrayTexture||x.isCompressedArrayTexture?Lt.setTexture2DArray(x,0):Lt.setTexture2D(x,0),ut.unbindTexture()},this.resetState=function(){$=0,G=0,tt=null,ut.reset(),rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return pn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;const e=this.getContext();e.drawingBufferColorSpace=$t._getDrawingBufferColorSpace(t),e.unpackColorSpace=$t._getUnpackColorSpace()}}const di=`
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;
precision highp usampler2D;
precision highp sampler2DShadow;
`,Cl=`
uniform ivec2 anchor;                 // x and z, modulo 2^30

uint mixed(uint h) {
  h ^= h >> 16; h *= 0x7feb352du; h ^= h >> 15; h *= 0x846ca68bu; h ^= h >> 16;
  return h;
}
float unit(uint h) { return float(h >> 8) * (1.0 / 16777216.0); }
float hash2(ivec2 p) { return unit(mixed(uint(p.x) * 0x9e3779b9u ^ mixed(uint(p.y)))); }
float hash3(ivec3 p) { return unit(mixed(uint(p.x) * 0x9e3779b9u ^ mixed(uint(p.y) * 0x85ebca6bu ^ mixed(uint(p.z))))); }

/** Value noise, 0 to 1, whose cells are 2^k blocks. */
float noise(vec2 p, int k) {
  vec2 q = p / float(1 << k);
  ivec2 cell = ivec2(floor(q)) + (anchor >> k);
  vec2 f = fract(q);
  f = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  return mix(mix(hash2(cell), hash2(cell + ivec2(1, 0)), f.x), mix(hash2(cell + ivec2(0, 1)), hash2(cell + ivec2(1, 1)), f.x), f.y);
}
`,Ll=`
uniform vec3 sunDirection;            // of what lights the land: the sun, or the moon at night
uniform vec3 sunLight;
uniform vec3 skyLight;                // from above, on a level floor
uniform vec3 groundLight;             // from below
uniform vec3 zenith;
uniform vec3 horizon;
uniform vec3 glow;                    // around the sun
uniform vec3 glowDirection;           // the sun's, at night too
uniform float horizonBlocks;
uniform float fogDensity;
uniform float mist;
uniform float seaLevel;               // relative to the anchor, as y always is
uniform vec4 waterFog;                // colour; w: 1 where the camera is under water
uniform float cloudCover;
uniform vec2 cloudShift;

/** The sky without sun, moon, stars and clouds: also what distance fades to. */
vec3 skyColour(vec3 direction) {
  float up = max(direction.y, 0.0);
  vec3 colour = mix(zenith, horizon, exp(-up * 4.5));
  colour = mix(colour, horizon * 1.08, exp(-up * 16.0) * 0.6);
  float toward = dot(direction, glowDirection);
  float low = exp(-up * 5.0);
  float wide = pow(max(toward * 0.5 + 0.5, 0.0), 6.0);
  float near = pow(max(toward, 0.0), 24.0);
  return colour + glow * (wide * low * 0.55 + near * 0.35 * (0.35 + low));
}

float cloudNoise(vec2 p) {
  p += cloudShift;
  return noise(p, 9) * 0.5 + noise(p + 311.0, 8) * 0.27 + noise(p - 97.0, 7) * 0.15;
}
const float CLOUD_HEIGHT = 620.0;

/** 0 to 1: how much of the sun's light clouds leave at a place. */
float cloudShade(vec3 p) {
  vec2 at = p.xz + sunDirection.xz / max(sunDirection.y, 0.18) * (CLOUD_HEIGHT - p.y);
  return 1.0 - 0.55 * smoothstep(0.56 - cloudCover * 0.25, 0.78 - cloudCover * 0.25, cloudNoise(at) + 0.04);
}

/** What the air does to light on its way. */
vec3 throughAir(vec3 colour, vec3 ray, vec3 eye) {
  float distance = length(ray);
  vec3 direction = ray / max(distance, 0.001);
  if (waterFog.w > 0.5) return mix(waterFog.rgb, colour * vec3(0.55, 0.85, 0.9), exp(-distance * 0.045));
  float far = distance / horizonBlocks;
  float thick = far * far * 3.4 * fogDensity;
  // Mist lies low: the integral of exp(-height / 40) along the ray.
  float from = max(eye.y - seaLevel, 0.0) / 40.0;
  float to = max(eye.y + ray.y - seaLevel, 0.0) / 40.0;
  float along = abs(to - from) < 0.01 ? exp(-from) : (exp(-from) - exp(-to)) / (to - from);
  thick += mist * distance * along;
  float edge = smoothstep(0.86, 1.0, length(ray.xz) / horizonBlocks);
  float kept = exp(-thick) * (1.0 - edge);
  return mix(skyColour(normalize(vec3(direction.x, max(direction.y, 0.0) * (1.0 - edge * 0.0) + 0.012, direction.z))), colour, kept);
}
`,Pl=`
uniform float exposure;
uniform float nightly;                // 0 by day, 1 at night: eyes see less colour

/** Filmic tone curve (after Hill's fit of the ACES reference), then sRGB. */
vec3 display(vec3 light) {
  light *= exposure;
  float grey = dot(light, vec3(0.2126, 0.7152, 0.0722));
  light = mix(light, vec3(grey) * vec3(0.85, 0.95, 1.15), nightly * 0.45);
  const mat3 toRrt = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
  const mat3 fromOdt = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
  vec3 v = toRrt * light;
  v = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
  v = clamp(fromOdt * v, 0.0, 1.0);
  return mix(12.92 * v, 1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), v));
}
`,vd=`
uniform sampler2DArray ground;        // by level: height of solid ground, of liquid, in voxels of the level
uniform vec2 viewCentre;              // of what the levels surround
uniform float level0Reach;            // blocks
uniform int levels;
uniform float groundBase;             // y of row 0

int levelAt(vec2 p) {
  vec2 d = abs(p - viewCentre);
  return clamp(int(ceil(log2(max(max(d.x, d.y), 1.0) / level0Reach))), 0, levels - 1);
}
vec3 groundPlace(vec2 p, int level) {
  float scale = float(1 << level);
  vec2 size = vec2(textureSize(ground, 0).xy);
  // Levels of up to 2^6 blocks a voxel: an anchor of multiples of 4,096 is whole in all of them.
  return vec3((p / scale + vec2((anchor >> level) & (ivec2(size) - 1))) / size, float(level));
}
/** Height of the ground at p, smooth. */
float groundAt(vec2 p, int level) {
  return texture(ground, groundPlace(p, level)).r * float(1 << level) + groundBase;
}
vec2 groundVoxel(vec2 p, int level) {
  ivec3 size = textureSize(ground, 0);
  ivec2 at = (ivec2(floor(p / float(1 << level))) + (anchor >> level)) & (size.xy - 1);
  return texelFetch(ground, ivec3(at, level), 0).rg * float(1 << level) + groundBase;
}
`,xd=`
uniform sampler2DShadow shadowMap;
uniform mat4 shadowMatrix;            // from eye-relative to the map
uniform float shadowReach;            // blocks; 0: none
uniform int marchSteps;

/** By the heights of the land: soft, and as far as one sees. */
float marched(vec3 p, float from, float dither) {
  if (sunDirection.y <= 0.0) return 0.0;
  float lit = 1.0;
  float t = from * (0.85 + 0.3 * dither);
  float up = sunDirection.y / max(length(sunDirection.xz), 0.001);
  vec2 along = sunDirection.xz / max(length(sunDirection.xz), 0.001);
  for (int i = 0; i < marchSteps; i++) {
    vec2 at = p.xz + along * t;
    float over = p.y + up * t - groundAt(at, levelAt(at));
    lit = min(lit, 0.5 + over * 14.0 / (t + 24.0));
    if (lit <= 0.0 || up * t > 420.0) break;
    t *= 1.42;
  }
  return smoothstep(0.0, 1.0, lit);
}
`,ES=`${di}
uniform mat4 inverseViewProjection;
out vec3 direction;
void main() {
  // One triangle over the whole picture, at the far end.
  vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  vec4 far = inverseViewProjection * vec4(at, 1.0, 1.0);
  direction = far.xyz / far.w;
  gl_Position = vec4(at, 1.0, 1.0);
}
`,bS=`${di}${Cl}${Ll}${Pl}
uniform vec3 eye;
uniform vec3 moonDirection;
uniform float stars;
uniform mat3 starTurn;
uniform float sunDisc;
in vec3 direction;
out vec4 result;

vec3 starLight(vec3 d) {
  vec3 q = starTurn * d;
  // Cells on the faces of a cube.
  vec3 a = abs(q);
  vec2 uv = a.x > a.y && a.x > a.z ? q.yz / a.x : a.y > a.z ? q.xz / a.y : q.xy / a.z;
  int face = a.x > a.y && a.x > a.z ? (q.x > 0.0 ? 0 : 1) : a.y > a.z ? (q.y > 0.0 ? 2 : 3) : (q.z > 0.0 ? 4 : 5);
  vec2 at = uv * 70.0;
  ivec2 cell = ivec2(floor(at));
  float chance = hash3(ivec3(cell, face));
  vec2 where = vec2(hash3(ivec3(cell, face + 10)), hash3(ivec3(cell, face + 20))) * 0.7 + 0.15;
  float size = 0.03 + 0.05 * pow(hash3(ivec3(cell, face + 30)), 6.0);
  float spot = 1.0 - smoothstep(size * 0.4, size + 0.04, length(fract(at) - where));
  float warm = hash3(ivec3(cell, face + 40));
  vec3 band = vec3(0.5, 0.6, 1.0) * 0.02 * pow(1.0 - abs(dot(q, normalize(vec3(0.3, 0.5, 0.8)))), 6.0);
  return step(0.82, chance) * spot * mix(vec3(1.0, 0.85, 0.7), vec3(0.75, 0.85, 1.0), warm) * (0.25 + chance * chance) + band;
}

void main() {
  vec3 d = normalize(direction);
  vec3 colour = skyColour(d);
  if (d.y < 0.0) colour = mix(colour, horizon * 0.9, min(-d.y * 3.0, 1.0));
  if (stars > 0.0 && d.y > -0.02) colour += starLight(d) * stars * smoothstep(-0.02, 0.25, d.y);
  float toSun = dot(d, glowDirection);
  colour += sunDisc * vec3(1.0, 0.86, 0.62) * (smoothstep(0.99955, 0.99975, toSun) * 22.0 + pow(max(toSun, 0.0), 900.0) * 2.0);
  float toMoon = dot(d, moonDirection);
  if (stars > 0.0 && toMoon > 0.99) {
    vec3 right = normalize(cross(moonDirection, vec3(0.0, 0.0, 1.0)));
    vec3 upward = cross(right, moonDirection);
    vec2 m = vec2(dot(d, right), dot(d, upward)) / 0.028;
    float disc = 1.0 - smoothstep(0.96, 1.02, length(m));
    float spots = noise(m * 3.0 + 40.0, 1) * 0.6 + noise(m * 7.0 + 90.0, 1) * 0.4;
    colour = mix(colour, vec3(0.95, 0.94, 0.88) * (0.55 + 0.45 * spots) * 1.3, disc * min(stars * 2.0, 1.0));
    colour += vec3(0.10, 0.12, 0.16) * stars * pow(max(toMoon, 0.0), 1200.0);
  }

  // Clouds on a plane high above: thick where noise is high, lit from the sun's side, lost in the distance.
  if (d.y > 0.015 && eye.y < CLOUD_HEIGHT) {
    float reach = (CLOUD_HEIGHT - eye.y) / d.y;
    vec2 at = eye.xz + d.xz * reach;
    float fine = noise(at * 4.0 + cloudShift * 4.0, 8) * 0.07 + noise(at * 8.0 + cloudShift * 9.0, 8) * 0.045;
    float base = cloudNoise(at) + fine;
    float threshold = 0.58 - cloudCover * 0.25;
    float density = smoothstep(threshold, threshold + 0.2, base);
    float toward = cloudNoise(at + glowDirection.xz * 90.0 * sign(sunDirection.y)) + fine;
    float lit = clamp(0.75 + (base - toward) * 3.2 - (base - threshold) * 0.9, 0.0, 1.3);
    vec3 shade = horizon * 0.32 + zenith * 0.3 + skyLight * 0.18;
    float silver = pow(max(toSun, 0.0), 12.0) * (1.0 - density) * 1.6;
    vec3 cloud = mix(shade, sunLight * 0.42 + skyLight * 0.36, lit * 0.85) + glow * (0.22 * lit + silver);
    colour = mix(colour, cloud, density * 0.92 * smoothstep(0.02, 0.16, d.y));
  }
  if (waterFog.w > 0.5) colour = waterFog.rgb;
  // Less than a step of colour, so that gradients show no bands.
  float noisy = hash2(ivec2(gl_FragCoord.xy)) - 0.5;
  result = vec4(display(colour) + noisy / 255.0, 1.0);
}
`,Il=`
uniform usampler2D quads;
uniform sampler2D slots;              // of each mesh: origin relative to the anchor, and blocks a voxel
uniform vec3 eye;                     // relative to the anchor
uniform mat4 viewProjection;          // from eye-relative positions

struct Corner { vec3 position; vec3 normal; float occlusion; uint face; uint material; bool cut; float scale; };

Corner unpackCorner(float widen) {
  uint quad = uint(gl_VertexID) >> 2;
  uint corner = uint(gl_VertexID) & 3u;
  uvec2 word = texelFetch(quads, ivec2(int(quad & 127u), int(quad >> 7)), 0).xy;
  uint slot = word.y & 0xffffu;
  vec4 origin = texelFetch(slots, ivec2(int(slot & 255u), int(slot >> 8)), 0);

  Corner c;
  c.face = (word.x >> 15) & 7u;
  uint axis = c.face == 0u || c.face == 3u ? 0u : c.face == 2u || c.face == 5u ? 1u : 2u;
  bool positive = c.face >= 2u && c.face <= 4u;
  corner = (corner + ((word.x >> 28) & 1u)) & 3u;
  // Front faces are counter-clockwise from outside.
  if ((axis == 2u) != positive) corner = (4u - corner) & 3u;
  vec2 at = vec2(corner == 1u || corner == 2u ? 1.0 : 0.0, corner >= 2u ? 1.0 : 0.0);
  vec2 size = vec2(float((word.x >> 18) & 31u) + 1.0, float((word.x >> 23) & 31u) + 1.0);

  vec3 local = vec3(float(word.x & 31u), float((word.x >> 5) & 31u), float((word.x >> 10) & 31u));
  vec3 along = axis == 0u ? vec3(0.0, at.y * size.y, at.x * size.x)
             : axis == 1u ? vec3(at.x * size.x, 0.0, at.y * size.y)
                          : vec3(at.x * size.x, at.y * size.y, 0.0);
  vec3 out_ = axis == 0u ? vec3(1.0, 0.0, 0.0) : axis == 1u ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
  c.normal = positive ? out_ : -out_;
  c.scale = origin.w;
  c.position = origin.xyz - eye + (local + along + (positive ? out_ : vec3(0.0))) * origin.w;
  // Edges that meet in a T leave pixels open between them: each quad is wider by a fraction of a pixel.
  vec2 apart = (at * 2.0 - 1.0) * length(c.position) * widen;
  c.position += axis == 0u ? vec3(0.0, apart.y, apart.x) : axis == 1u ? vec3(apart.x, 0.0, apart.y) : vec3(apart.x, apart.y, 0.0);
  c.occlusion = float((word.y >> (16u + 2u * corner)) & 3u);
  c.material = (word.y >> 24) | ((word.x >> 30) << 8);
  c.cut = ((word.x >> 29) & 1u) == 1u;
  return c;
}
`,TS=`${di}${Il}
out vec3 ray;
out float occlusion;
flat out vec3 normal;
flat out uvec2 about;                 // material, and bit 0: cut, bit 1: top, bit 2: along x
flat out float scale;

void main() {
  Corner c = unpackCorner(0.0003);
  ray = c.position;
  normal = c.normal;
  occlusion = c.occlusion / 3.0;
  scale = c.scale;
  about = uvec2(c.material, (c.cut ? 1u : 0u));
  gl_Position = viewProjection * vec4(c.position, 1.0);
}
`,AS=`${di}${Cl}${Ll}${Pl}${vd}${xd}
uniform vec3 eye;
uniform sampler2D materials;          // two texels each: colour and kind; colour below, and grain
uniform vec4 slice;                   // normal x, z, distance; w: 1 where there is one
uniform float time;
uniform float detail;                 // 0: far taps are left out
uniform float borders;
uniform vec3 selected;                // voxel, relative to the anchor; far away: none

in vec3 ray;
in float occlusion;
flat in vec3 normal;
flat in uvec2 about;
flat in float scale;
out vec4 result;

const int ROCK = 0, TURF = 1, SAND = 2, SNOW = 3, LEAVES = 4, WOOD = 5, ICE = 6, ORE = 7, RUBBLE = 8, EARTH = 9;

vec2 onFace(vec3 p) { return abs(normal.x) > 0.5 ? p.zy : abs(normal.y) > 0.5 ? p.xz : p.xy; }

/** How much of the sky is open above a place: the land's own heights around it, near and farther. */
float openness(vec3 p, vec3 n, int level, out vec2 slope) {
  vec3 q = p + n * 0.55 * scale;
  float y = q.y;
  float roof = groundAt(q.xz, level) - y;
  float open = 1.0 - smoothstep(0.0, 1.6 * scale, roof);
  float near = 0.0, far = 0.0;
  slope = vec2(0.0);
  float r1 = 2.2 * scale, r2 = 7.0 * scale;
  vec2 d = vec2(0.7071, 0.7071);
  for (int i = 0; i < 4; i++) {
    float beside = groundAt(q.xz + d * r1, level) - y;
    slope += d * beside;
    near += clamp(beside / (r1 * 2.2), 0.0, 1.0);
    if (detail > 0.5) far += clamp((groundAt(q.xz + vec2(d.x - d.y, d.x + d.y) * 0.7071 * r2, level) - y) / (r2 * 1.8), 0.0, 1.0);
    d = vec2(-d.y, d.x);
  }
  near *= 0.25;
  far *= 0.25;
  slope /= 2.0 * r1;
  if (abs(roof) > 4.0 * scale || length(slope) > 3.0) slope = vec2(0.0, 1e6);
  float around = 1.0 - (detail > 0.5 ? near * 0.5 + far * 0.5 : near);
  return around * (0.25 + 0.75 * open) * mix(1.0, 0.35, (1.0 - open) * near);
}

void main() {
  if (slice.w > 0.5 && dot(ray.xz, slice.xy) > slice.z + 0.02 && (about.y & 1u) == 0u) {
    // A staircase of faces stands out beyond the plane by up to a voxel.
    if (dot(ray.xz, slice.xy) > slice.z + 0.75 * scale) discard;
  }
  vec3 p = ray + eye;
  float distance = length(ray);
  vec3 toEye = -ray / max(distance, 0.001);
  bool top = normal.y > 0.5;
  bool side = abs(normal.y) < 0.5;
  bool cut = (about.y & 1u) == 1u;

  vec4 first = texelFetch(materials, ivec2(0, int(about.x)), 0);
  vec4 second = texelFetch(materials, ivec2(1, int(about.x)), 0);
  int kind = int(first.a + 0.5);
  vec3 albedo = first.rgb;

  // Where this is: the voxel, and of its column the heights of ground and water.
  vec3 inside = p - normal * 0.5 * scale;
  ivec3 voxel = ivec3(floor(inside / scale));
  ivec3 worldVoxel = voxel + ivec3(anchor.x, 0, anchor.y) / int(scale);
  int level = int(log2(scale) + 0.5);
  vec2 column = groundVoxel(inside.xz, level);
  float depth = column.x - p.y;

  // Large areas are not flat: broad, slow changes of tint; and each voxel is itself.
  float broad = noise(p.xz, 8) * 0.55 + noise(p.xz + 57.0, 6) * 0.45;
  float mid = noise(p.xz - 31.0, 4);
  float own = hash3(worldVoxel);
  float nearly = 1.0 - smoothstep(40.0, 160.0, distance / scale);
  float grainy = 1.0 - smoothstep(14.0, 60.0, distance);

  // Texels of 1/12 block, that fade before they flicker.
  vec2 uv = onFace(p);
  ivec2 texel = ivec2(floor(uv * 12.0));
  float speck = hash2(texel + worldVoxel.xz * 7 + worldVoxel.y * 131);
  float speck2 = hash2((texel >> 1) + worldVoxel.zx * 5 + worldVoxel.y * 57);
  vec2 cell = fract(uv / scale);

  float shine = 0.0;
  float through = 0.0;                // light that leaves let through
  float swing = 0.06;
  if (kind == TURF) {
    albedo = mix(albedo, vec3(dot(albedo, vec3(0.3, 0.6, 0.1))), 0.16) * 0.88;
    vec3 dry = mix(albedo, albedo * vec3(1.28, 1.06, 0.55), 0.65);
    vec3 lush = albedo * vec3(0.72, 0.92, 0.66);
    albedo = mix(albedo, dry, smoothstep(0.48, 0.85, broad) * 0.75);
    albedo = mix(albedo, lush, smoothstep(0.55, 0.2, broad) * 0.6);
    albedo *= 0.9 + 0.2 * mid;
    if (side && scale < 1.5) {
      // Earth under the turf, which hangs over its edge.
      float fringe = 0.22 + 0.2 * hash2(ivec2(texel.x, worldVoxel.y) + worldVoxel.xz * 3);
      float under = smoothstep(fringe - 0.02, fringe + 0.02, depth) * (0.35 + 0.65 * grainy + (1.0 - grainy) * 0.15);
      albedo = mix(albedo, second.rgb * (0.9 + 0.2 * own), clamp(under, 0.0, 1.0) * 0.85);
    }
    albedo *= 1.0 + grainy * ((speck - 0.5) * 0.26 + (speck2 - 0.5) * 0.16);
    swing = 0.07;
    through = 0.06;
  } else if (kind == SAND) {
    float ripple = sin((p.x * 0.8 + p.z * 0.35 + mid * 9.0) * 2.6);
    albedo *= 0.93 + 0.12 * broad + 0.025 * ripple * grainy;
    albedo *= 1.0 + grainy * (speck - 0.5) * 0.14;
    swing = 0.03;
  } else if (kind == SNOW) {
    albedo *= vec3(0.94, 0.97, 1.0) * (0.94 + 0.06 * broad);
    albedo *= 1.0 + grainy * (speck - 0.5) * 0.05;
    shine = 0.25 * step(0.985, speck) * grainy;
    swing = 0.02;
  } else if (kind == LEAVES) {
    float tree = hash2((worldVoxel.xz + 3) >> 3);
    albedo *= mix(vec3(0.78, 0.9, 0.7), vec3(1.3, 1.12, 0.8), tree * 0.6 + broad * 0.4);
    // Clumps of light and shade, and gaps that go deep.
    float gap = step(0.74, speck2) * grainy;
    albedo *= (0.86 + 0.3 * own) * (1.0 + grainy * (speck - 0.5) * 0.5) * (1.0 - 0.5 * gap);
    swing = 0.0;
    through = 0.35;
  } else if (kind == WOOD) {
    float bark = hash2(ivec2(texel.x, texel.y >> 2) + worldVoxel.y * 3);
    albedo = mix(albedo, vec3(dot(albedo, vec3(0.35, 0.5, 0.15))), 0.3) * 1.1;
    albedo *= side ? 1.0 + grainy * (bark - 0.5) * 0.55 : 1.0 + grainy * (speck - 0.5) * 0.2;
  } else if (kind == ICE) {
    albedo *= 0.92 + 0.14 * mid;
    albedo *= 1.0 + grainy * (speck2 - 0.5) * 0.08;
    shine = 0.5;
  } else if (kind == ORE) {
    vec3 host = second.rgb * (0.92 + 0.16 * own);
    float lump = step(0.52, hash2((texel / 3) + worldVoxel.xz * 5 + worldVoxel.y * 17));
    albedo = mix(host, albedo * (0.85 + 0.5 * speck), mix(0.62, lump, grainy));
    shine = 0.35 * lump * grainy;
  } else if (kind == RUBBLE) {
    float stone = hash2((texel / 3) + worldVoxel.xz * 5 + worldVoxel.y * 17);
    albedo *= 1.0 + grainy * ((stone - 0.5) * 0.4 + (speck - 0.5) * 0.12);
    albedo *= 0.9 + 0.2 * mid;
    swing = 0.12;
  } else if (kind == EARTH) {
    albedo *= 1.0 + grainy * ((speck - 0.5) * 0.22 + (speck2 - 0.5) * 0.16);
    albedo *= 0.92 + 0.16 * mid;
  } else {
    // Rock: beds a little uneven in tone, fine level lines on walls, weathered where the sky washes it.
    float bed = hash2(ivec2(worldVoxel.y, 7 + int(floor(mid * 3.0))));
    albedo *= 0.93 + 0.12 * bed + 0.1 * (broad - 0.5);
    if (side) albedo *= 1.0 + grainy * (hash2(ivec2(texel.x >> 3, texel.y) + worldVoxel.y) - 0.5) * 0.18;
    albedo *= 1.0 + grainy * ((speck - 0.5) * 0.14 + (speck2 - 0.5) * 0.12);
    swing = 0.08;
  }
  albedo *= 1.0 + (own - 0.5) * 2.0 * swing * mix(0.45, 1.0, nearly);

  // Edges of voxels catch the light a little, and the joint between them is a little dark.
  float border = min(min(cell.x, 1.0 - cell.x), min(cell.y, 1.0 - cell.y)) * scale;
  float crisp = 1.0 - smoothstep(6.0, 34.0, distance);
  albedo *= 1.0 - 0.16 * crisp * (1.0 - smoothstep(0.0, 0.035, border)) + 0.05 * crisp * (1.0 - smoothstep(0.035, 0.1, border));
  if (all(equal(voxel, ivec3(floor(selected)))) && scale < 1.5) {
    albedo = mix(albedo, vec3(1.0), border < 0.045 ? 0.85 : 0.12);
  }

  // Light.
  vec2 slope;
  float open = openness(p, normal, level, slope);
  if (cut) open = 1.0;
  float corner = mix(0.42, 1.0, occlusion * (0.35 + 0.65 * occlusion));
  corner = mix(1.0, corner, cut ? 0.0 : 1.0 / (1.0 + max(scale - 1.0, 0.0) * 0.35));
  // Faces of voxels stand in for a rough surface: far away its lean shows, not its steps.
  vec3 lean = slope.y > 1e5 ? normal : normalize(vec3(-slope.x, 1.0, -slope.y));
  float rough = smoothstep(24.0, 190.0, distance / scale * 1.0) * 0.85;
  vec3 shading = normalize(mix(normal, lean, rough));
  // A cut is a plane, although it is made of steps.
  if (cut) shading = normalize(vec3(slice.x, 0.55, slice.y));
  float facing = cut ? 0.5 : max(dot(shading, sunDirection), 0.0);
  float dither = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) * 0.5 + 0.25;
  float lit = 0.0;
  if (facing > 0.0 || through > 0.0) {
    float mapped = 1.0;
    vec3 start = p + normal * 0.35 * scale + sunDirection * 0.2 * scale;
    vec3 inMap = (shadowMatrix * vec4(ray + normal * (0.06 + 0.05 * distance / 60.0), 1.0)).xyz;
    float near = shadowReach > 0.0 ? 1.0 - smoothstep(shadowReach * 0.8, shadowReach, length(ray)) : 0.0;
    if (near > 0.0 && all(lessThan(abs(inMap - 0.5), vec3(0.499)))) {
      vec2 texelSize = 1.0 / vec2(textureSize(shadowMap, 0));
      mapped = 0.0;
      for (int i = 0; i < 4; i++) {
        vec2 shift = vec2(float(i & 1), float(i >> 1)) - 0.5 + (dither - 0.5) * 0.4;
        mapped += texture(shadowMap, vec3(inMap.xy + shift * texelSize * 1.5, inMap.z));
      }
      mapped *= 0.25;
    } else {
      near = 0.0;
    }
    float far = near < 1.0 || shadowReach <= 0.0 ? marched(start, 1.4 * scale, dither) : marched(start, shadowReach * 0.5, dither);
    lit = cut ? 1.0 : near > 0.0 ? mix(far, min(mapped, far), near) : far;
    lit *= cloudShade(p);
  }
  vec3 sun = sunLight * lit * mix(facing, 0.5 + 0.5 * facing, through);
  if (through > 0.0) sun *= 1.0 + through * 0.8 * pow(max(dot(-toEye, sunDirection), 0.0), 3.0);
  float up = shading.y * 0.5 + 0.5;
  vec3 ambient = mix(groundLight, skyLight, up) * (open * 0.92 + 0.08);
  // A breath of light in caves, or one would see nothing at all.
  ambient += vec3(0.012, 0.013, 0.016);
  if (side && !cut) ambient *= abs(normal.x) > 0.5 ? 0.94 : 1.04;
  vec3 light = sun * mix(corner, 1.0, 0.6) + ambient * corner;
  vec3 colour = albedo * light;
  if (shine > 0.0) {
    vec3 halfway = normalize(toEye + sunDirection);
    colour += sunLight * lit * shine * pow(max(dot(normal, halfway), 0.0), 60.0);
  }

  // Under water: what is left of the light on its way down and up, and what the water sends itself.
  float under = column.y - p.y;
  if (under > 0.02 && waterFog.w < 0.5) {
    float path = under * (1.0 + 0.6 / max(toEye.y, 0.25));
    colour *= exp(-vec3(0.30, 0.085, 0.06) * min(path, 40.0));
    colour += vec3(0.012, 0.075, 0.095) * (1.0 - exp(-path * 0.11)) * (sunLight * 0.28 + skyLight * 0.75);
  }
  if (under > 0.02) {
    float w = time * 0.7;
    float wave = noise(p.xz * 8.0 + vec2(w * 9.0, w * 4.0), 3) + noise(p.xz * 8.0 - vec2(w * 5.0, w * 8.0), 3);
    colour *= 1.0 + 0.7 * pow(1.0 - abs(wave - 1.0), 8.0) * lit * exp(-under * 0.16) * (1.0 - smoothstep(40.0, 120.0, distance));
  }
  // Wet where water has just been.
  if (kind == SAND && top) {
    float wet = 1.0 - smoothstep(0.4, 1.6, p.y - seaLevel);
    colour *= 1.0 - 0.25 * wet * step(0.0, p.y - seaLevel);
  }
  colour = throughAir(colour, ray, eye);
  if (borders > 0.5) {
    vec2 within = fract(onFace(p - vec3(0.0, groundBase, 0.0)) / (32.0 * scale));
    float line = min(min(within.x, 1.0 - within.x), min(within.y, 1.0 - within.y)) * 32.0 * scale;
    vec3 tint = level == 0 ? vec3(1.0, 0.8, 0.2) : level == 1 ? vec3(0.2, 0.9, 1.0) : level == 2 ? vec3(1.0, 0.35, 0.8) : vec3(0.5, 1.0, 0.4);
    colour = mix(colour, tint, 0.8 * (1.0 - smoothstep(0.5, 1.0, line / max(0.06, distance * 0.0016))));
  }
  result = vec4(display(colour), 1.0);
}
`,RS=`${di}${Il}
void main() {
  Corner c = unpackCorner(0.0);
  gl_Position = viewProjection * vec4(c.position, 1.0);
}
`,CS=`${di}
void main() {}
`,LS=`${di}${Il}
out vec3 ray;
flat out vec3 normal;
flat out float scale;
flat out uint material;

void main() {
  Corner c = unpackCorner(0.0003);
  ray = c.position;
  // The surface lies a little below its voxel's top, at every level of detail alike.
  if (c.normal.y > 0.5) ray.y -= 0.14;
  normal = c.normal;
  scale = c.scale;
  material = c.material;
  gl_Position = viewProjection * vec4(ray, 1.0);
}
`,PS=`${di}${Cl}${Ll}${Pl}${vd}${xd}
uniform vec3 eye;
uniform sampler2D materials;
uniform vec4 slice;
uniform float time;

in vec3 ray;
flat in vec3 normal;
flat in float scale;
flat in uint material;
out vec4 result;

/** Slope of the waves, of three lengths that go their own ways. */
vec2 slopeOf(vec2 p, float distance) {
  vec2 slope = vec2(0.0);
  float t = time;
  vec2 drift = vec2(t * 1.1, t * 0.6);
  for (int i = 0; i < 3; i++) {
    float fine = 1.0 - smoothstep(60.0, 500.0, distance * (i == 0 ? 1.0 : i == 1 ? 0.4 : 0.12));
    int k = i == 0 ? 1 : i == 1 ? 3 : 5;
    float size = float(1 << k);
    vec2 q = p + drift * (i == 1 ? -0.8 : 1.0) * (1.0 + float(i));
    float e = size * 0.2;
    float here = noise(q, k);
    slope += vec2(noise(q + vec2(e, 0.0), k) - here, noise(q + vec2(0.0, e), k) - here) * fine * (i == 0 ? 0.16 : i == 1 ? 0.2 : 0.16);
  }
  return slope;
}

void main() {
  if (slice.w > 0.5 && dot(ray.xz, slice.xy) > slice.z + 0.5 * scale) discard;
  vec3 p = ray + eye;
  float distance = length(ray);
  vec3 toEye = -ray / max(distance, 0.001);
  vec4 first = texelFetch(materials, ivec2(0, int(material)), 0);
  vec3 n = normal;
  if (normal.y > 0.5) {
    vec2 slope = slopeOf(p.xz, distance);
    n = normalize(vec3(-slope.x, 1.0, -slope.y));
  }
  bool below = waterFog.w > 0.5;
  if (below) n = -n;
  float facing = max(dot(n, toEye), 0.0);
  float mirror = 0.02 + 0.98 * pow(1.0 - facing, 5.0);
  vec3 colour;
  float alpha;
  if (below) {
    // From under water: the sky in a round window, and beyond its rim the water itself.
    float window = smoothstep(0.6, 0.75, toEye.y * -1.0);
    colour = mix(waterFog.rgb * 1.2, skyColour(normalize(vec3(-toEye.x, max(-toEye.y, 0.05), -toEye.z))), window);
    alpha = mix(0.85, 0.35, window);
  } else {
    vec3 away = reflect(-toEye, n);
    away.y = abs(away.y);
    vec3 seen = skyColour(away);
    // Hills stand in the mirror: where the land rises that way, it is dark.
    int level = levelAt(p.xz);
    float hill = 0.0;
    float t = 14.0;
    for (int i = 0; i < 5; i++) {
      vec2 at = p.xz + away.xz * t;
      hill = max(hill, smoothstep(-2.0, 10.0, groundAt(at, levelAt(at)) - (p.y + away.y * t)));
      t *= 2.0;
    }
    seen = mix(seen, (skyLight * 0.10 + sunLight * 0.04) * vec3(0.55, 0.7, 0.4) + seen * 0.25, hill * 0.8);
    float lit = marched(p + vec3(0.0, 0.4, 0.0), 1.5, 0.5) * cloudShade(p);
    float depth = p.y - groundAt(p.xz, level);
    float thin = max(depth, 0.0);
    vec3 body = mix(first.rgb * vec3(0.35, 0.75, 0.8), vec3(0.012, 0.085, 0.11), 0.6) * (sunLight * 0.3 * lit + skyLight * 0.8);
    float murk = (1.0 - exp(-thin * 0.10)) * 0.55 + 0.06;
    // Glitter.
    vec3 halfway = normalize(toEye + sunDirection);
    float glint = pow(max(dot(n, halfway), 0.0), 340.0) * 7.0 + pow(max(dot(n, halfway), 0.0), 60.0) * 0.25;
    // A line of foam along the shore, that comes and goes.
    float swash = noise(p.xz * 2.0 + time * 0.9, 2) * 0.6 + noise(p.xz * 4.0 - time * 0.7, 1) * 0.4;
    float foam = (1.0 - smoothstep(0.0, 0.9, thin + (swash - 0.5) * 1.1)) * step(scale, 1.5) * (1.0 - smoothstep(60.0, 260.0, distance));
    foam *= smoothstep(0.35, 0.65, swash + 0.12);
    alpha = 1.0 - (1.0 - mirror) * (1.0 - murk);
    colour = (seen * mirror + body * (1.0 - mirror) * murk) / alpha;
    colour += sunLight * glint * lit * mirror * 6.0;
    vec3 white = (sunLight * 0.7 * lit * max(sunDirection.y, 0.0) + skyLight) * 0.75;
    colour = mix(colour, white, foam * 0.7);
    alpha = max(alpha, foam * 0.7);
    alpha = mix(alpha, 1.0, smoothstep(0.3, 1.0, distance / horizonBlocks));
  }
  result = vec4(display(throughAir(colour, ray, eye)), alpha);
}
`,Re=(i,t)=>Math.floor(i/t);function IS(i,t){const e=Math.ceil(t/32),n=[];for(let s=1,r=i;s<=6&&r<e;s++)r=s===6?e:Math.min(i*2**s,e),n.push({lod:s,radius:r});return n}function kh(i,t,e,n,s){const r=i.limits,a=Re(i.minY,32),o=Re(i.maxY-1,32),l=Math.min(Math.max(Math.ceil((o-a)/2),1),r.viewVerticalRadius),c=Math.max(a+l,Math.min(Re(t.y,32),o-l));return{centre:{x:Math.floor(t.x),y:c*32+16,z:Math.floor(t.z)},direction:e,horizontalRadius:Math.min(n,r.viewHorizontalRadius),verticalRadius:l,rings:IS(Math.min(n,r.viewHorizontalRadius),s),horizon:r.viewHorizon}}function DS(i,t){const e=Re(i.centre.x,32),n=Re(i.centre.y,32),s=Re(i.centre.z,32),r=[];let a={lod:0,x0:e-i.horizontalRadius,x1:e+i.horizontalRadius,z0:s-i.horizontalRadius,z1:s+i.horizontalRadius,y0:n-i.verticalRadius,y1:n+i.verticalRadius,hole:null};return r[0]=a,(i.rings??[]).forEach(({lod:o,radius:l},c)=>{const h=2**o,u=2**(o-a.lod),d={x0:Math.ceil(a.x0/u),x1:Re(a.x1+1,u)-1,z0:Math.ceil(a.z0/u),z1:Re(a.z1+1,u)-1},f=i.horizon===!0&&c===0||d.x1<d.x0||d.z1<d.z0;a=r[o]={lod:o,x0:Re(e-l,h),x1:Re(e+l,h),z0:Re(s-l,h),z1:Re(s+l,h),y0:i.horizon?Re(Re(t.minY,h)-1,32):Re(n-i.verticalRadius,h),y1:i.horizon?Re(Re(t.maxY-1,h),32):Re(n+i.verticalRadius,h),hole:f?null:d}}),r}const el=(i,t,e)=>t>=i.x0&&t<=i.x1&&e>=i.z0&&e<=i.z1;function Sd(i,t,e,n){const s=i[t];return s!==void 0&&el(s,e,n)&&!(s.hole!==null&&el(s.hole,e,n))}function Bh(i,t,e,n){const s=i[t];return s!==void 0&&el(s,e,n)}function NS(i){let t=0;for(const e of i){if(e===void 0)continue;const n=s=>(s.x1-s.x0+1)*(s.z1-s.z0+1);t+=(n(e)-(e.hole===null?0:n(e.hole)))*(e.y1-e.y0+1)}return t}function US(i,t){const e=new Set,n=i.length-1,s=(c,h,u)=>t.get(c,h,u)?.ready?!0:c>0&&r(c,h,u),r=(c,h,u)=>s(c-1,2*h,2*u)&&s(c-1,2*h+1,2*u)&&s(c-1,2*h,2*u+1)&&s(c-1,2*h+1,2*u+1),a=(c,h,u)=>{const d=o(c-1,2*h,2*u),f=o(c-1,2*h+1,2*u),_=o(c-1,2*h,2*u+1),S=o(c-1,2*h+1,2*u+1);return d||f||_||S},o=(c,h,u)=>{const d=t.get(c,h,u);return c>0&&Bh(i,c-1,2*h,2*u)&&Bh(i,c-1,2*h+1,2*u+1)&&r(c,h,u)?a(c,h,u):d?.ready?(e.add(d),!0):c>0&&a(c,h,u)?!0:d?.begun?(e.add(d),!0):!1};if(n<0)return e;const l=i[n];for(let c=l.z0;c<=l.z1;c++)for(let h=l.x0;h<=l.x1;h++)o(n,h,c);return e}function FS(i,t,e,n){let s=1/0;for(const r of i){if(r===void 0)continue;const a=32*2**r.lod;for(let o=r.z0;o<=r.z1;o++)for(let l=r.x0;l<=r.x1;l++){if(!Sd(i,r.lod,l,o)||t.get(r.lod,l,o)?.ready)continue;const c=Math.max(l*a-e,e-(l+1)*a,0),h=Math.max(o*a-n,n-(o+1)*a,0);s=Math.min(s,c*c+h*h)}}return s===1/0?null:Math.sqrt(s)}const zh=1048575,Ur=(i,t,e)=>((t&zh)*1048576+(e&zh))*8+i,OS=(i,t,e,n)=>`${Ur(i,t,n)}/${e}`,Gh=32,kS=(i,t,e)=>(t*Gh+e)*Gh+i,_r=(i,t,e)=>(t-i.x)*i.nx+(e-i.z)*i.nz;function nl(i,t,e,n){const s=[_r(i,t,e),_r(i,t+n,e),_r(i,t,e+n),_r(i,t+n,e+n)];return Math.max(...s)<=0?"kept":Math.min(...s)>=0?"gone":"cut"}class BS{constructor(t,e){this.column=t,this.y=e}payload=null;material=null;arrived=0;known=0;meshedWith=-1;meshedSlice=null;changed=!1;job=null;queued=!1;left=!1;drawable=null;tops=null;liquidTops=null;get lod(){return this.column.lod}get x(){return this.column.x}get z(){return this.column.z}}class zS{constructor(t,e,n){this.lod=t,this.x=e,this.z=n}chunks=new Map;around=0;wanted=!1;drawn=!1;ready=!1;begun=!1;stale=!0;heights=null;liquids=null;lowest=-32768;drawables=[];left=0;cut=!1;skirts=0}const On=-32768;class GS{constructor(t){this.options=t}shape=[];slice=null;columns=new Map;jobs=new Map;queue=[];queueSorted=!1;nextJob=1;coverStale=!0;coveredAt=-1/0;cover=new Set;version=0;camera={x:0,y:0,z:0};held=0;payloadBytes=0;heldPerLevel=[0,0,0,0,0,0,0];get(t,e,n){return this.columns.get(Ur(t,e,n))}values(){return this.columns.values()}get settled(){return this.queue.length===0&&this.jobs.size===0&&!this.coverStale}get waiting(){return this.queue.length+this.jobs.size}get drawn(){return this.cover}nearestMissing(t,e){return FS(this.shape,this,t,e)}setShape(t){const e=t.map((n,s)=>n?.y0!==this.shape[s]?.y0||n?.y1!==this.shape[s]?.y1);this.shape=t;for(const n of this.columns.values()){const s=n.around;if(this.placeInShape(n),!(s===n.around&&!e[n.lod]))for(const r of n.chunks.values())this.consider(r)}this.coverStale=!0}setSlice(t){this.slice=t;for(const e of this.columns.values()){const n=this.isCut(e);if(n||e.cut)for(const s of e.chunks.values())this.consider(s);e.cut=n}this.version++}add(t,e,n,s,r,a){let o=this.get(t,e,s);o===void 0&&(o=new zS(t,e,s),this.columns.set(Ur(t,e,s),o),this.placeInShape(o));let l=o.chunks.get(n);const c=l===void 0;l===void 0&&(l=new BS(o,n),o.chunks.set(n,l));const h=l.left;(c||h)&&(this.held++,this.heldPerLevel[t]++),h&&o.left--,l.left=!1,this.payloadBytes+=(r?.length??0)-(l.payload?.length??0),l.payload=r,l.material=a,l.arrived=this.options.now(),l.changed=!0,this.options.meshers.send(l),this.eachNeighbour(l,(u,d)=>{u.left||(l.known|=1<<d,u.known|=1<<26-d,c||(u.changed=!0),this.consider(u))}),this.consider(l)}leave(t,e,n,s){const r=this.get(t,e,s)?.chunks.get(n);r===void 0||r.left||(r.left=!0,r.column.left++,this.payloadBytes-=r.payload?.length??0,r.payload=null,r.known=0,this.held--,this.heldPerLevel[t]--,this.options.meshers.drop(r),this.eachNeighbour(r,(a,o)=>{a.known&=~(1<<26-o)}),r.job!==null&&this.cancel(r),r.drawable===null&&r.meshedWith<0&&this.forget(r),this.coverStale=!0)}meshed(t,e){const n=this.jobs.get(t);if(this.jobs.delete(t),n===void 0||n.job?.id!==t)return;const s=n.job;n.job=null;const r=e.quads.length>0?this.options.drawer.add(s.slot,e):null;r===null&&this.options.drawer.freeSlot(s.slot),n.meshedWith<0&&this.options.arrivedToDrawn(this.options.now()-n.arrived),this.replace(n,r,s.known,s.slice),s.slice===null&&(n.tops=e.tops,n.liquidTops=e.liquidTops,n.column.stale=!0),this.consider(n)}failed(t){const e=this.jobs.get(t);this.jobs.delete(t),e?.job?.id===t&&(this.options.drawer.freeSlot(e.job.slot),e.job=null)}update(t,e){const n=this.options.now();Math.abs(t.x-this.camera.x)+Math.abs(t.z-this.camera.z)>24&&(this.camera={...t},this.queueSorted=!1),this.dispatch(),this.coverStale&&n-this.coveredAt>80&&this.recover(e)}loseMeshes(){for(const t of this.columns.values()){t.ready=t.begun=!1,t.stale=!0,t.drawables=[];for(const e of[...t.chunks.values()])e.drawable!==null&&this.options.drawer.remove(e.drawable),e.drawable=null,e.meshedWith=-1,e.left?this.forget(e):this.consider(e)}this.coverStale=!0}clear(){for(const t of[...this.columns.values()])for(const e of[...t.chunks.values()])this.leave(e.lod,e.x,e.y,e.z),this.forget(e);this.queue=[],this.coverStale=!0,this.recover(1/0)}placeInShape(t){t.around=0;for(let e=-1;e<=1;e++)for(let n=-1;n<=1;n++)Sd(this.shape,t.lod,t.x+n,t.z+e)&&(t.around|=1<<(e+1)*3+n+1);t.wanted=(t.around&16)!==0}wantedAround(t){const e=this.shape[t.lod];if(e===void 0)return 0;const n=t.column.around;let s=(n&-17)<<9;return t.y>e.y0&&(s|=n),t.y<e.y1&&(s|=n<<18),s}eachNeighbour(t,e){for(let n=-1;n<=1;n++)for(let s=-1;s<=1;s++){const r=s===0&&n===0?t.column:this.get(t.lod,t.x+s,t.z+n);if(r!==void 0)for(let a=-1;a<=1;a++){if(s===0&&a===0&&n===0)continue;const o=r.chunks.get(t.y+a);o!==void 0&&e(o,(a+1)*9+(n+1)*3+s+1)}}}consider(t){if(t.left||t.queued||t.job!==null||(this.wantedAround(t)&~t.known)!==0)return;const n=this.sliceOf(t);if(!(t.meshedWith>=0&&!t.changed&&(t.known&~t.meshedWith)===0&&t.meshedSlice===n)){if(this.isPlain(t)){const r=t.meshedWith<0;this.replace(t,null,t.known,n),t.changed=!1,(r||t.tops!==null)&&(t.tops=null,t.column.stale=!0);return}t.queued=!0,this.queue.push(t),this.queueSorted=!1}}sliceOf(t){return this.isCut(t.column)?this.slice:null}isCut(t){if(this.slice===null)return!1;const e=32*2**t.lod;return nl(this.slice,(t.x-1/32)*e,(t.z-1/32)*e,e*1.0625)==="cut"}isPlain(t){if(t.material===null)return!1;const e=this.options.kindOf(t.material);if(e==="gas")return!0;if(this.sliceOf(t)!==null)return!1;let n=!0;const s=(r,a,o)=>{const l=(a+1)*9+(o+1)*3+r+1;if(!n||!(t.known>>>l&1))return;const c=this.get(t.lod,t.x+r,t.z+o)?.chunks.get(t.y+a);if(c===void 0||c.material===null){n=!1;return}const h=this.options.kindOf(c.material);h==="solid"||h===e||(n=!1)};return s(-1,0,0),s(1,0,0),s(0,-1,0),s(0,1,0),s(0,0,-1),s(0,0,1),n}replace(t,e,n,s){t.drawable!==null&&this.options.drawer.remove(t.drawable);const r=t.drawable!==null;t.drawable=e,(r||e!==null)&&this.gather(t.column),t.meshedWith=n,t.meshedSlice=s,t.column.begun||=e!==null,t.column.stale||=!t.column.ready,this.coverStale=!0,this.version++}priority(t){const e=32*2**t.lod,n=(t.x+.5)*e-this.camera.x,s=(t.y+.5)*e-this.camera.y,r=(t.z+.5)*e-this.camera.z;return Math.hypot(n,r)+(s>0?s*.25:-s*.5)+(t.meshedWith>=0&&t.meshedSlice===this.sliceOf(t)?200:0)}dispatch(){if(this.queue.length===0)return;if(!this.queueSorted){const e=new Map(this.queue.map(n=>[n,this.priority(n)]));this.queue.sort((n,s)=>e.get(s)-e.get(n)),this.queueSorted=!0}const t=[];for(;this.queue.length>0&&t.length<32;){const e=this.queue.pop();if(e.queued=!1,e.left||(this.wantedAround(e)&~e.known)!==0)continue;if(!this.options.meshers.hasRoom(e)){e.queued=!0,t.push(e);continue}const n=this.sliceOf(e),s=this.options.drawer.takeSlot(e.lod,e.x,e.y,e.z),r=this.nextJob++;e.job={id:r,known:e.known,slice:n,slot:s},e.changed=!1,this.jobs.set(r,e),this.options.meshers.mesh(e,{id:r,lod:e.lod,x:e.x,y:e.y,z:e.z,slot:s,known:e.known,slice:n})}for(let e=t.length-1;e>=0;e--)this.queue.push(t[e])}cancel(t){this.jobs.delete(t.job.id),this.options.drawer.freeSlot(t.job.slot),t.job=null}forget(t){t.drawable!==null&&this.options.drawer.remove(t.drawable),t.drawable=null;const e=t.column;t.left&&e.left--,e.chunks.delete(t.y),this.gather(e),e.chunks.size===0&&this.columns.delete(Ur(e.lod,e.x,e.z))}gather(t){t.drawables=[];for(const e of t.chunks.values())e.drawable!==null&&t.drawables.push(e.drawable)}recover(t){this.coverStale=!1,this.coveredAt=this.options.now();let e=0;for(const s of this.columns.values())if(s.stale){if(e++>=24&&this.options.now()-this.coveredAt>t){this.coverStale=!0;break}this.refresh(s)}this.version++;const n=this.cover;this.cover=US(this.shape,this);for(const s of n)s.drawn=!1;for(const s of this.cover)s.drawn=!0;for(const s of this.cover){const{lod:r,x:a,z:o}=s;s.skirts=(this.get(r,a-1,o)?.drawn?0:1)|(this.get(r,a,o-1)?.drawn?0:2)|(this.get(r,a+1,o)?.drawn?0:4)|(this.get(r,a,o+1)?.drawn?0:8)}for(const s of[...this.columns.values()])if(!(s.left===0||s.drawn&&!s.wanted))for(const r of[...s.chunks.values()])r.left&&!(s.drawn&&!s.ready)&&this.forget(r)}refresh(t){t.stale=!1;const e=this.shape[t.lod];if(e===void 0||t.chunks.size===0)return;let n=null,s=null,r=1024,a=!0;for(let o=e.y1;o>=e.y0&&r>0;o--){const l=t.chunks.get(o);if(l===void 0||l.meshedWith<0){a=!1;continue}const c=l.material===null?null:this.options.kindOf(l.material);if(!(c==="gas"||c===null&&l.tops===null)){if(n??=new Int16Array(1024).fill(On),c==="liquid"||l.liquidTops!==null){s??=new Int16Array(1024).fill(On);for(let h=0;h<1024;h++){const u=c==="liquid"?32:l.liquidTops[h];u>0&&n[h]===On&&s[h]===On&&(s[h]=o*32+u)}}if(c!=="liquid")for(let h=0;h<1024;h++){if(n[h]!==On)continue;const u=c==="solid"?32:l.tops[h];u!==0&&(n[h]=o*32+u,r--)}}}if(t.ready=a,n!==null||s!==null){t.heights=n,t.liquids=s;let o=32767;if(n!==null)for(let l=0;l<1024;l++)n[l]<o&&(o=n[l]);t.lowest=n===null?On:o,this.options.heights(t)}}}class HS{constructor(t){this.size=t,this.free=[{first:0,count:t}]}free;get freeRows(){return this.free.reduce((t,e)=>t+e.count,0)}take(t){for(let e=0;e<this.free.length;e++){const n=this.free[e];if(n.count<t)continue;const s=n.first;return n.first+=t,n.count-=t,n.count===0&&this.free.splice(e,1),s}return-1}give(t,e){let n=this.free.findIndex(a=>a.first>t);n<0&&(n=this.free.length);const s=this.free[n-1],r=this.free[n];s!==void 0&&s.first+s.count===t?(s.count+=e,r!==void 0&&s.first+s.count===r.first&&(s.count+=r.count,this.free.splice(n,1))):r!==void 0&&t+e===r.first?(r.first=t,r.count+=e):this.free.splice(n,0,{first:t,count:e})}}const Fn=128,il=2048,Kr=Fn*il,VS=Kr*8;function WS(){const i=new Uint32Array(Kr*6);for(let t=0,e=0;t<Kr;t++){const n=t*4;i[e++]=n,i[e++]=n+1,i[e++]=n+2,i[e++]=n,i[e++]=n+2,i[e++]=n+3}return new Xn(i,1)}class XS extends $n{isBatchedMesh=!0;_colorsTexture=null;_multiDrawInstances=null;_multiDrawStarts=new Int32Array(1024);_multiDrawCounts=new Int32Array(1024);_multiDrawCount=0;constructor(t,e){super(t,e),this.frustumCulled=!1,this.matrixAutoUpdate=!1}empty(){this._multiDrawCount=0}push(t,e){const n=this._multiDrawCount;if(n>0&&this._multiDrawStarts[n-1]/24+this._multiDrawCounts[n-1]/6===t){this._multiDrawCounts[n-1]+=e*6;return}if(n===this._multiDrawStarts.length){const s=new Int32Array(n*2);s.set(this._multiDrawStarts),this._multiDrawStarts=s;const r=new Int32Array(n*2);r.set(this._multiDrawCounts),this._multiDrawCounts=r}this._multiDrawStarts[n]=t*24,this._multiDrawCounts[n]=e*6,this._multiDrawCount=n+1}}class qS{constructor(t){this.renderer=t,this.geometry.setIndex(WS())}pages=[];geometry=new Yn;get bytes(){return this.pages.length*VS+Kr*24}add(t){const e=Math.ceil(t.length/2/Fn);let n=0,s=-1;for(;n<this.pages.length&&(s=this.pages[n].ranges.take(e),!(s>=0));n++);if(s<0){n=this.pages.length;const r=new ta(null,Fn,il,Qr,an);r.internalFormat="RG32UI",r.minFilter=r.magFilter=xe,r.source.dataReady=!1,r.needsUpdate=!0,this.pages.push({texture:r,ranges:new HS(il)}),s=this.pages[n].ranges.take(e)}return this.upload(this.pages[n].texture,s,e,t),{page:n,firstQuad:s*Fn,rows:e}}remove(t){this.pages[t.page].ranges.give(t.firstQuad/Fn,t.rows)}dispose(){for(const t of this.pages)t.texture.dispose();this.geometry.dispose()}upload(t,e,n,s){const r=Dl(this.renderer,t),a=Math.floor(s.length/2/Fn),o=Fn*2;a>0&&r.texSubImage2D(r.TEXTURE_2D,0,0,e,Fn,a,r.RG_INTEGER,r.UNSIGNED_INT,s,0);const l=s.length/2-a*Fn;n>a&&r.texSubImage2D(r.TEXTURE_2D,0,0,e+a,l,1,r.RG_INTEGER,r.UNSIGNED_INT,s,a*o)}}function Dl(i,t,e=3553){const n=i.getContext();i.initTexture(t);const{__webglTexture:s}=i.properties.get(t);i.state.activeTexture(n.TEXTURE0),i.state.bindTexture(e,s);const r=i.state,a=r.pixelStorei?.bind(r)??n.pixelStorei.bind(n);return a(n.UNPACK_FLIP_Y_WEBGL,!1),a(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),a(n.UNPACK_ALIGNMENT,1),n}const Md=ju.toHalfFloat(-2048),Rs=2047,$S=Uint16Array.from({length:2*Rs+1},(i,t)=>ju.toHalfFloat(t-Rs)),YS=4;class KS{constructor(t,e,n,s){this.renderer=t,this.levels=n,this.base=s,this.size=(2*e+3)*32<=1024?1024:2048;const r=new bl(null,this.size,this.size,n);r.format=ui,r.type=gn,r.internalFormat="RG16F",r.minFilter=r.magFilter=Fe,r.wrapS=r.wrapT=zr,r.source.dataReady=!1,r.needsUpdate=!0,this.texture=r,this.clear()}texture;size;part=new Uint16Array(1024*2);get bytes(){return this.size*this.size*this.levels*YS}set(t){if(t.lod>=this.levels)return;const e=this.base>>t.lod,{heights:n,liquids:s}=t;for(let o=0;o<1024;o++)this.part[2*o]=Hh(n?.[o]??On,e),this.part[2*o+1]=Hh(s?.[o]??On,e);const r=this.size/32,a=o=>(o%r+r)%r*32;this.write(a(t.x),a(t.z),t.lod,32,32,this.part)}clear(){const t=new Uint16Array(this.size*64*2).fill(Md);for(let e=0;e<this.levels;e++)for(let n=0;n<this.size;n+=64)this.write(0,n,e,this.size,64,t)}dispose(){this.texture.dispose()}write(t,e,n,s,r,a){const o=Dl(this.renderer,this.texture,35866);o.texSubImage3D(o.TEXTURE_2D_ARRAY,0,t,e,n,s,r,1,o.RG,o.HALF_FLOAT,a)}}function Hh(i,t){return i===On?Md:$S[Math.min(Math.max(i-t,-Rs),Rs)+Rs]}const qt=(i,t)=>{const e=new Yt(i);return[e.r*t,e.g*t,e.b*t]},vr=[{at:-.3,sunLight:qt(11124991,.3),skyLight:qt(3821712,.5),zenith:qt(264218,1),horizon:qt(990264,1),glow:qt(0,0),exposure:2.1},{at:-.14,sunLight:qt(11124991,.12),skyLight:qt(4874400,.65),zenith:qt(660534,1),horizon:qt(2898536,.9),glow:qt(10504250,.45),exposure:2},{at:-.03,sunLight:qt(16747082,.1),skyLight:qt(8423608,.85),zenith:qt(1847408,1),horizon:qt(8220816,.75),glow:qt(16739890,1.35),exposure:1.7},{at:.06,sunLight:qt(16751186,2.3),skyLight:qt(9214152,.85),zenith:qt(3430558,1),horizon:qt(13347492,.82),glow:qt(16747068,1.3),exposure:1.25},{at:.22,sunLight:qt(16762250,3.7),skyLight:qt(8825056,.85),zenith:qt(3106488,.95),horizon:qt(13683664,.92),glow:qt(16758896,.7),exposure:.95},{at:.5,sunLight:qt(16770754,4.3),skyLight:qt(8827630,1.05),zenith:qt(2779332,.9),horizon:qt(11850478,.98),glow:qt(16769720,.35),exposure:.86},{at:1,sunLight:qt(16773852,4.6),skyLight:qt(8566002,1.15),zenith:qt(2384578,.9),horizon:qt(11062768,1),glow:qt(16773336,.25),exposure:.84}],fs=(i,t,e)=>new O(...i.map((n,s)=>n+(t[s]-n)*e)),ps=(i,t,e)=>{const n=Math.min(Math.max((e-i)/(t-i),0),1);return n*n*(3-2*n)};function Vh(i){const t=(i-6)/24*2*Math.PI,e=.55,n=new O(Math.cos(t),Math.sin(t)*Math.cos(e),Math.sin(t)*Math.sin(e)).normalize(),s=new O(-n.x,-n.y*.9,n.z*.2+.35).normalize(),r=n.y;let a=0;for(;a<vr.length-2&&r>vr[a+1].at;)a++;const o=vr[a],l=vr[a+1],c=Math.min(Math.max((r-o.at)/(l.at-o.at),0),1),h=r>-.05,u=h?ps(-.05,.03,r):ps(-.05,-.16,r),d=h?n.clone():s.clone();d.y=Math.max(d.y,.035),d.normalize();const f=fs(o.sunLight,l.sunLight,c).multiplyScalar(u),_=fs(o.skyLight,l.skyLight,c),S=new Pt().setFromMatrix4(new jt().makeRotationAxis(new O(0,Math.sin(.7),Math.cos(.7)).normalize(),-t));return{direction:d,sun:n,moon:s,sunLight:f,skyLight:_,groundLight:_.clone().multiply(new O(.42,.36,.28)).addScaledVector(new O(f.x*.075,f.y*.065,f.z*.045),Math.max(d.y,0)+.2),zenith:fs(o.zenith,l.zenith,c),horizon:fs(o.horizon,l.horizon,c),glow:fs(o.glow,l.glow,c),exposure:o.exposure+(l.exposure-o.exposure)*c,stars:ps(-.02,-.2,r),night:ps(0,-.18,r),mist:6e-4+.0016*(1-ps(.08,.4,Math.abs(r))),starTurn:S}}const ZS=1024,xr=65536,JS=[{axis:0,sign:-1},{axis:2,sign:-1},{axis:1,sign:1},{axis:0,sign:1},{axis:2,sign:1},{axis:1,sign:-1}],[QS,jS,gy,tM,eM]=[0,1,2,3,4,5],nM=[QS,jS,tM,eM],Wh=JS.length+nM.length,Sr=256,Qa=4096;function Xh(i){const t=i.elements,e=new Float64Array(24);for(let n=0;n<6;n++){const s=n>>1,r=n&1?-1:1;for(let a=0;a<4;a++)e[n*4+a]=t[a*4+3]+r*t[a*4+s]}return e}class iM{constructor(t,e){this.renderer=t,this.makeMaterial=e,this.pages=new qS(t),this.slots=new ta(this.slotData,Sr,xr/Sr,rn,sn),this.slots.minFilter=this.slots.magFilter=xe,this.slots.needsUpdate=!0;for(const n of[this.solid,this.liquid,this.shadow])n.matrixWorldAutoUpdate=!1}solid=new Dr;liquid=new Dr;shadow=new Dr;slots;anchor={x:0,y:0,z:0};meshes=0;quads=0;pages;slotData=new Float32Array(xr*4);used=[];freeSlots=[];sets=[];get bytes(){return this.pages.bytes+xr*16}takeSlot(t,e,n,s){const r=this.freeSlots.pop()??this.used.length;if(r>=xr)throw new Error("the view has more meshes than there are slots; make it smaller");this.used[r]={lod:t,x:e,y:n,z:s},this.writeSlot(r);const a=Dl(this.renderer,this.slots);return a.texSubImage2D(a.TEXTURE_2D,0,r%Sr,Math.floor(r/Sr),1,1,a.RGBA,a.FLOAT,this.slotData,r*4),r}freeSlot(t){this.used[t]=null,this.freeSlots.push(t)}add(t,e){const n=this.pages.add(e.quads);for(;this.sets.length<=n.page;)this.addPage();const{lod:s,x:r,y:a,z:o}=this.used[t],l=2**s,c=e.quads.length/2;return this.meshes++,this.quads+=c,{slot:t,place:n,counts:e.counts,quads:c,scale:l,x:r*32*l,y:a*32*l,z:o*32*l,low:e.low,high:e.high}}remove(t){this.pages.remove(t.place),this.freeSlot(t.slot),this.meshes--,this.quads-=t.quads}setAnchor(t,e,n){this.anchor={x:t,y:e,z:n};for(let s=0;s<this.used.length;s++)this.used[s]&&this.writeSlot(s);this.slots.needsUpdate=!0}list(t,e,n,s,r){for(const o of this.sets)o.solid.empty(),o.liquid.empty();const a=Xh(n);for(const o of t){const l=32*2**o.lod,c=o.x*l-e.x,h=o.z*l-e.z;if(!(s!==null&&nl(s,o.x*l,o.z*l,l)==="gone"))for(const u of o.drawables){const d=u.y+u.low*u.scale-e.y,f=u.y+(u.high+1)*u.scale-e.y;r&&o.ready&&u.y+(u.high+1)*u.scale<(o.lowest-6)*u.scale&&(o.lod>0||c*c+h*h>25600)||qh(a,c,d,h,l,f)&&this.push(u,c,d,h,l,f,o.skirts)}}}listShadow(t,e,n,s,r){for(const o of this.sets)o.shadow.empty();const a=Xh(n);for(const o of t){if(o.lod>1)continue;const l=32*2**o.lod,c=o.x*l-e.x,h=o.z*l-e.z;if(!(r!==null&&nl(r,o.x*l,o.z*l,l)==="gone"))for(const u of o.drawables){const d=u.y+(u.high+1)*u.scale;if(o.ready&&d<(o.lowest-2)*u.scale||!qh(a,c,u.y+u.low*u.scale-e.y,h,l,d-e.y))continue;const f=u.counts,_=this.sets[u.place.page].shadow;let S=u.place.firstQuad;for(let p=0;p<6;p++)(p===0?s.x<0:p===3?s.x>0:p===1?s.z<0:p===4?s.z>0:p===2)&&f[p]>0&&_.push(S,f[p]),S+=f[p]}}}dispose(){this.pages.dispose(),this.slots.dispose();for(const{solid:t,liquid:e,shadow:n}of this.sets)for(const s of[t,e,n])s.material.dispose()}push(t,e,n,s,r,a,o){const l=this.sets[t.place.page],c=t.counts;let h=t.place.firstQuad;for(let u=0;u<10;u++){const d=c[u];if(d>0){const f=u<6?u:u-6<2?u-6:u-5;(f===0?e+r>0:f===3?e<0:f===1?s+r>0:f===4?s<0:f===2?n<0:a>0)&&(u<6||o>>u-6&1)&&l.solid.push(h,d),h+=d}}c[Wh]>0&&l.liquid.push(h,c[Wh])}addPage(){const t=this.sets.length,e=(n,s)=>{const r=this.makeMaterial(n);r.uniforms.quads={value:this.pages.pages[t].texture},r.uniforms.slots={value:this.slots};const a=new XS(this.pages.geometry,r);return s.add(a),a};this.sets.push({solid:e("solid",this.solid),liquid:e("liquid",this.liquid),shadow:e("shadow",this.shadow)})}writeSlot(t){const{lod:e,x:n,y:s,z:r}=this.used[t],a=2**e;this.slotData[t*4]=n*32*a-this.anchor.x,this.slotData[t*4+1]=s*32*a-this.anchor.y,this.slotData[t*4+2]=r*32*a-this.anchor.z,this.slotData[t*4+3]=a}}function qh(i,t,e,n,s,r){for(let a=0;a<24;a+=4){const o=i[a],l=i[a+1],c=i[a+2];if(o*(o>0?t+s:t)+l*(l>0?r:e)+c*(c>0?n+s:n)+i[a+3]<0)return!1}return!0}const $h=new O(1e9,1e9,1e9);class sM{renderer;terrain;ground=null;light=Vh(10);triangles=0;drawCalls=0;camera=new dn(70,1,.12,8e3);viewProjection=new jt;sky=new Dr;uniforms;shadowUniforms;shadowTarget=null;shadowCentre=new O(1/0,0,0);shadowDirection=new O;shadowMatrix=new jt;shadowAt=-1/0;shadowStale=!0;shadowReach=0;skyMaterial;constructor(t,e){this.renderer=new wS({canvas:t,antialias:e==="high",powerPreference:"high-performance",stencil:!1,alpha:!1}),this.renderer.autoClear=!1,this.renderer.sortObjects=!1,this.renderer.info.autoReset=!1,this.uniforms={eye:{value:new O},viewProjection:{value:this.viewProjection},inverseViewProjection:{value:new jt},anchor:{value:new Zt},materials:{value:null},ground:{value:null},viewCentre:{value:new Zt},level0Reach:{value:400},levels:{value:1},groundBase:{value:0},shadowMap:{value:null},shadowMatrix:{value:new jt},shadowReach:{value:0},marchSteps:{value:12},slice:{value:new de},time:{value:0},detail:{value:1},borders:{value:0},selected:{value:$h.clone()},sunDirection:{value:new O},sunLight:{value:new O},skyLight:{value:new O},groundLight:{value:new O},zenith:{value:new O},horizon:{value:new O},glow:{value:new O},glowDirection:{value:new O},moonDirection:{value:new O},horizonBlocks:{value:4096},fogDensity:{value:1},mist:{value:0},seaLevel:{value:0},waterFog:{value:new de},cloudCover:{value:.5},cloudShift:{value:new Zt},exposure:{value:1},nightly:{value:0},stars:{value:0},starTurn:{value:new Pt},sunDisc:{value:1}},this.shadowUniforms={eye:{value:new O},viewProjection:{value:new jt}},this.terrain=new iM(this.renderer,r=>this.makeMaterial(r)),this.skyMaterial=new ys({glslVersion:Ki,vertexShader:ES,fragmentShader:bS,uniforms:this.uniforms,depthWrite:!1});const n=new Yn;n.setAttribute("position",new Xn(new Float32Array(9),3));const s=new $n(n,this.skyMaterial);s.frustumCulled=!1,this.sky.add(s),this.setQuality(e)}get gpuBytes(){const t=this.shadowTarget===null?0:this.shadowTarget.width**2*8;return this.terrain.bytes+(this.ground?.bytes??0)+t}setQuality(t){this.set("detail",t==="high"?1:0),this.set("marchSteps",t==="high"?14:8),this.shadowTarget?.depthTexture?.dispose(),this.shadowTarget?.dispose(),this.shadowTarget=null,this.shadowReach=t==="high"?120:0;const e=t==="high"?2048:1,n=new Pi(e,e,an);n.compareFunction=yl,n.minFilter=n.magFilter=Fe,this.shadowTarget=new mn(e,e,{depthTexture:n,depthBuffer:!0,stencilBuffer:!1}),this.set("shadowMap",n),this.set("shadowReach",this.shadowReach),this.shadowStale=!0}setMaterials(t){this.uniforms.materials.value?.dispose(),this.set("materials",t)}setGround(t){this.ground?.dispose(),this.ground=t,this.set("ground",t?.texture??null),this.set("levels",t?.levels??1)}setReach(t,e,n,s){this.viewCentre.set(t,e),this.set("level0Reach",n),this.set("horizonBlocks",s),this.camera.far=s*1.6+1e3,this.camera.updateProjectionMatrix()}viewCentre=new Zt;setTimeOfDay(t){this.light=Vh(t),this.shadowStale=!0}setBorders(t){this.set("borders",t?1:0)}setFov(t){this.camera.fov=t,this.camera.updateProjectionMatrix()}resize(t,e,n){this.renderer.setPixelRatio(n),this.renderer.setSize(t,e,!1),this.camera.aspect=t/Math.max(e,1),this.camera.updateProjectionMatrix()}contextRestored(){this.terrain.slots.needsUpdate=!0,this.shadowStale=!0,this.shadowAt=-1/0}landChanged(){this.shadowStale=!0}draw(t){const{eye:e,columns:n,slice:s}=t;this.moveAnchor(e);const r=this.terrain.anchor,a=this.uniforms;if(a.eye.value.set(e.x-r.x,e.y-r.y,e.z-r.z),a.anchor.value.set(r.x%2**30,r.z%2**30),a.viewCentre.value.set(this.viewCentre.x-r.x,this.viewCentre.y-r.z),this.set("groundBase",t.groundBase-r.y),this.set("seaLevel",(t.seaLevel??-1e6)-r.y),this.set("time",t.seconds%3600),a.cloudShift.value.set(t.seconds*2.2%131072,t.seconds*.9%131072),a.selected.value.copy($h),t.selected){const{x:h,y:u,z:d}=t.selected;a.selected.value.set(h-r.x,u-r.y,d-r.z)}a.slice.value.set(s?.nx??0,s?.nz??0,s===null?0:(s.x-e.x)*s.nx+(s.z-e.z)*s.nz,s===null?0:1),this.applyLight(t.underWater),this.camera.rotation.set(e.pitch,-e.yaw,0,"YXZ"),this.camera.updateMatrixWorld(!0),this.viewProjection.multiplyMatrices(this.camera.projectionMatrix,this.camera.matrixWorldInverse),a.inverseViewProjection.value.copy(this.viewProjection).invert();const{renderer:l,terrain:c}=this;l.info.reset(),this.castShadows(e,n,t.now,s),c.list(n,e,this.viewProjection,s,t.hideBuried),l.setRenderTarget(null),l.clear(!0,!0,!1),l.render(c.solid,this.camera),l.render(this.sky,this.camera),l.render(c.liquid,this.camera),this.triangles=l.info.render.triangles,this.drawCalls=l.info.render.calls}dispose(){this.terrain.dispose(),this.setGround(null),this.skyMaterial.dispose(),this.uniforms.materials.value?.dispose(),this.shadowTarget?.depthTexture?.dispose(),this.shadowTarget?.dispose(),this.renderer.dispose()}set(t,e){this.uniforms[t].value=e}makeMaterial(t){return t==="shadow"?new ys({glslVersion:Ki,vertexShader:RS,fragmentShader:CS,uniforms:{...this.shadowUniforms},side:ci,colorWrite:!1,polygonOffset:!0,polygonOffsetFactor:1.5,polygonOffsetUnits:2}):t==="liquid"?new ys({glslVersion:Ki,vertexShader:LS,fragmentShader:PS,uniforms:{...this.uniforms},side:bn,transparent:!0,forceSinglePass:!0}):new ys({glslVersion:Ki,vertexShader:TS,fragmentShader:AS,uniforms:{...this.uniforms}})}moveAnchor(t){const e=this.terrain.anchor;if(Math.max(Math.abs(t.x-e.x),Math.abs(t.z-e.z),Math.abs(t.y-e.y))<=Qa)return;const s=r=>Math.round(r/Qa)*Qa;this.terrain.setAnchor(s(t.x),s(t.y),s(t.z))}applyLight(t){const e=this.light;for(const r of["sunLight","skyLight","groundLight","zenith","horizon","glow"])this.uniforms[r].value.copy(e[r]);this.uniforms.sunDirection.value.copy(e.direction),this.uniforms.glowDirection.value.copy(e.sun),this.uniforms.moonDirection.value.copy(e.moon),this.uniforms.starTurn.value.copy(e.starTurn),this.set("exposure",e.exposure),this.set("nightly",e.night),this.set("stars",e.stars),this.set("sunDisc",e.sun.y>-.05?1:0),this.set("mist",e.mist);const n=this.uniforms.waterFog.value,s=.25*(e.sunLight.y*.3+e.skyLight.y);n.set(.05*s,.42*s,.5*s,t?1:0)}castShadows(t,e,n,s){const r=this.shadowTarget;if(r===null)return;if(this.shadowReach===0){this.shadowStale&&this.renderer.initRenderTarget(r),this.shadowStale=!1;return}const a=this.light.direction;if(!(Math.hypot(t.x-this.shadowCentre.x,t.y-this.shadowCentre.y,t.z-this.shadowCentre.z)<24)||a.distanceToSquared(this.shadowDirection)>1e-6||this.shadowStale&&n-this.shadowAt>400){this.shadowStale=!1,this.shadowAt=n,this.shadowDirection.copy(a),this.shadowCentre.set(Math.floor(t.x),Math.floor(t.y),Math.floor(t.z));const u=this.shadowReach+28,d=new jt().lookAt(a,new O,new O(0,1,.001)).setPosition(0,0,0).invert(),f=420,_=new jt().makeOrthographic(-u,u,u,-u,-f,f);this.shadowMatrix.multiplyMatrices(_,d);const S=this.terrain.anchor;this.shadowUniforms.eye.value.set(this.shadowCentre.x-S.x,this.shadowCentre.y-S.y,this.shadowCentre.z-S.z),this.shadowUniforms.viewProjection.value.copy(this.shadowMatrix),this.terrain.listShadow(e,this.shadowCentre,this.shadowMatrix,a,s),this.renderer.setRenderTarget(r),this.renderer.clear(!1,!0,!1),this.renderer.render(this.terrain.shadow,this.camera)}const c=new jt().makeScale(.5,.5,.5).setPosition(.5,.5,.5).multiply(this.shadowMatrix),h=new jt().makeTranslation(t.x-this.shadowCentre.x,t.y-this.shadowCentre.y,t.z-this.shadowCentre.z);this.uniforms.shadowMatrix.value.multiplyMatrices(c,h)}}const rM={rock:0,turf:1,sand:2,snow:3,leaves:4,wood:5,ice:6,ore:7,rubble:8,earth:9},aM=[[/leaves|needles|bush|hedge|foliage/,"leaves"],[/wood|bark|log|trunk|timber|plank/,"wood"],[/\bice\b|glacier/,"ice"],[/snow|firn/,"snow"],[/\bore\b|coal|copper|silver|gold|iron\b|crystal/,"ore"],[/scree|gravel|shingle|pebble|rubble|cobble|talus/,"rubble"],[/sandstone|limestone/,"rock"],[/beach|desert$|\bsand\b|dune|sea floor/,"sand"],[/grass|meadow|forest|jungle|taiga|tundra|savanna|moss|turf|heath|steppe|prairie|cactus/,"turf"],[/soil|dirt|earth|clay|mud|peat|loam|humus/,"earth"]];function oM(i){const t=i.name.toLowerCase();for(const[e,n]of aM)if(e.test(t))return n;return"rock"}function lM(i){const t=new Float32Array(i.length*8),e=new Yt,n=new Yt(i.find(a=>/soil|dirt|earth/.test(a.name))?.colour??8018750),s=new Yt(i.find(a=>a.phase==="solid")?.colour??7762038);i.forEach((a,o)=>{const l=oM(a);e.set(a.colour);const c=l==="ore"?s:/cactus/.test(a.name)?e:n;t.set([e.r,e.g,e.b,rM[l],c.r,c.g,c.b,0],o*8)});const r=new ta(t,2,i.length,rn,sn);return r.minFilter=r.magFilter=xe,r.needsUpdate=!0,r}const Yh=0,Kh=1,ja=2;class Zh{values;count=0;constructor(t){this.values=new Float32Array(t)}add(t){this.values[this.count++%this.values.length]=t}percentiles(...t){const e=Math.min(this.count,this.values.length);if(e===0)return null;const n=this.values.slice(0,e).sort();return t.map(s=>n[Math.min(e-1,Math.floor(e*s))])}clear(){this.count=0}}class cM{seconds=new Float64Array(2);second=-1;add(t){this.turn(t),this.seconds[0]++}at(t){this.turn(t);const e=t/1e3%1;return Math.round(this.seconds[0]+this.seconds[1]*(1-e))}turn(t){const e=Math.floor(t/1e3);e!==this.second&&(this.seconds[1]=e===this.second+1?this.seconds[0]:0,this.seconds[0]=0,this.second=e)}}function hM(i,t,e,n,s){const r=Math.hypot(t.x,t.y,t.z);if(!(r>0))return null;const a=[i.x,i.y,i.z],o=[t.x/r,t.y/r,t.z/r],l=a.map(Math.floor),c=o.map(Math.sign),h=o.map(_=>_===0?1/0:Math.abs(1/_)),u=o.map((_,S)=>_===0?1/0:(_>0?l[S]+1-a[S]:a[S]-l[S])*h[S]);let d=0,f=-1;for(;d<=e;){const _=n(l[0],l[1],l[2]);if(_===void 0)return null;if(s(_)){const S=[0,0,0];return f>=0&&(S[f]=-c[f]),{x:l[0],y:l[1],z:l[2],material:_,distance:d,normal:{x:S[0],y:S[1],z:S[2]}}}f=u[0]<u[1]?u[0]<u[2]?0:2:u[1]<u[2]?1:2,d=u[f],u[f]+=h[f],l[f]+=c[f]}return null}const Jh=3,uM=6,dM=i=>Math.min(4,Math.max(2,i-1));class fM{constructor(t,e,n){this.handle=n,this.crews=Array.from({length:t},()=>{const s={worker:e(),jobs:0,chunks:[],drops:[],orders:[],heldBytes:0};return s.worker.onmessage=r=>this.answered(s,r.data),s})}crews;ownerOfJob=new Map;meshMs=0;meshes=0;get heldBytes(){return this.crews.reduce((t,e)=>t+e.heldBytes,0)}get meanMs(){return this.meshes===0?0:this.meshMs/this.meshes}setWorld(t,e){for(const n of this.crews)this.post(n,{kind:"world",kinds:t,places:e})}send(t){const{lod:e,x:n,y:s,z:r,payload:a,material:o}=t;for(const l of this.holdersOf(e,n,r))l.chunks.push({lod:e,x:n,y:s,z:r,payload:o===null?a:null,material:o})}drop(t){const{lod:e,x:n,y:s,z:r}=t;for(const a of this.holdersOf(e,n,r))a.chunks.length>0&&this.flushCrew(a),a.drops.push({lod:e,x:n,y:s,z:r})}hasRoom(t){return this.ownerOf(t.lod,t.x,t.z).jobs<uM}mesh(t,e){const n=this.ownerOf(t.lod,t.x,t.z);n.jobs++,n.orders.push(e),this.ownerOfJob.set(e.id,n)}flush(){for(const t of this.crews)this.flushCrew(t)}dispose(){for(const t of this.crews)t.worker.terminate()}flushCrew(t){t.drops.length>0&&this.post(t,{kind:"drop",chunks:t.drops.splice(0)}),t.chunks.length>0&&this.post(t,{kind:"chunks",chunks:t.chunks.splice(0)}),t.orders.length>0&&this.post(t,{kind:"mesh",jobs:t.orders.splice(0)})}post(t,e){t.worker.postMessage(e)}ownerOf(t,e,n){const s=this.crews.length,r=(e>>Jh)+(n>>Jh)+t;return this.crews[(r%s+s)%s]}holdersOf(t,e,n){const s=new Set;for(let r=-1;r<=1;r++)for(let a=-1;a<=1;a++)s.add(this.ownerOf(t,e+a,n+r));return s}answered(t,e){this.ownerOfJob.delete(e.id)&&t.jobs--,e.kind==="meshed"&&(this.meshMs+=e.ms,this.meshes++,t.heldBytes=e.heldBytes),this.handle(e)}}function pM(i){const{uniform:t,voxels:e}=rm(i);return e??t}const mM=128;class gM{decoded=new Map;get bytes(){return this.decoded.size*65536}at(t,e,n,s){if(t.material!==null)return t.material;if(t.payload===null)return;const r=OS(t.lod,t.x,t.y,t.z);let a=this.decoded.get(r);return(a===void 0||a.payload!==t.payload)&&(a={payload:t.payload,voxels:pM(t.payload)},this.decoded.set(r,a),this.decoded.size>mM&&this.decoded.delete(this.decoded.keys().next().value)),typeof a.voxels=="number"?a.voxels:a.voxels[kS(e,n,s)]}clear(){this.decoded.clear()}}const _M=250,Qh=3e3;class Nl{constructor(t){this.options=t,this.radius=t.radius,this.horizon=t.horizon,this.token=t.token,this.reducedMotion=t.reducedMotion,this.frames=vM(t),this.pool=new fM(dM(navigator.hardwareConcurrency??2),()=>new Worker(new URL(""+new URL("worker-B9Dlm2po.js",import.meta.url).href,import.meta.url),{type:"module"}),e=>{this.disposed||(e.kind==="meshed"?this.land.meshed(e.id,e.mesh):(this.land.failed(e.id),e.text!=="not held"&&this.emit("error",`a chunk does not decode: ${e.text}`)))}),this.land=new GS({drawer:this.frames.terrain,meshers:this.pool,kindOf:e=>this.kindOf(e),now:()=>performance.now(),heights:e=>{this.frames.ground?.set(e),e.liquids!==null&&this.seaLevel===null&&this.seeSea(e.liquids,e.lod)},arrivedToDrawn:e=>this.latency.add(e)}),t.canvas.addEventListener("webglcontextlost",this.onContextLost),t.canvas.addEventListener("webglcontextrestored",this.onContextRestored),this.connect()}static async create(t){const e=new Nl(t);try{await e.joined}catch(n){throw e.dispose(),n}return e}info=null;client;joined;frames;pool;land;voxels=new gM;handlers=new Map;kinds=new Uint8Array;state="connecting";viewComplete=!1;complete=!1;eye={x:0,y:0,z:0,yaw:0,pitch:0};viewSent={x:1/0,y:0,z:0,yaw:0,at:-1/0};chunksWanted=0;radius;horizon;token;slice=null;selection=null;lost=!1;disposed=!1;started=performance.now();firstFrameMs=null;completeMs=null;latency=new Zh(1024);cpu=new Zh(256);updated=0;rate=new cM;untaken=[];seaLevel=null;drawnVersion=-1;reducedMotion;wantsPicture=[];get world(){if(this.info===null)throw new Error("the engine has not joined yet");return{...this.info,seaLevel:this.seaLevel}}setCamera(t,e,n,s,r){this.eye={x:t,y:e,z:n,yaw:s,pitch:r}}setFov(t){this.frames.setFov(t)}resize(t,e,n){this.frames.resize(t,e,n)}update(){if(this.disposed)return;const t=performance.now();this.sendView(t),this.takeBacklog(),this.land.update(this.eye,4),this.pool.flush(),this.settle(t),this.updated+=performance.now()-t}frame(t){if(this.disposed)return;const e=performance.now();!this.lost&&this.info!==null&&this.draw(t),this.cpu.add(performance.now()-e+this.updated),this.updated=0}voxelAt(t,e,n){if(this.info!==null&&e>=this.info.maxY)return 0;const s=this.land.get(0,Math.floor(t/32),Math.floor(n/32))?.chunks.get(Math.floor(e/32));if(s===void 0||s.left)return;const r=a=>(a%32+32)%32;return this.voxels.at(s,r(t),r(e),r(n))}raycast(t,e,n,s=!1){return hM(t,e,n,(r,a,o)=>this.voxelAt(r,a,o),r=>this.isSolid(r)||s&&this.isLiquid(r))}isSolid(t){return this.kindOf(t)==="solid"}isLiquid(t){return this.kindOf(t)==="liquid"}setTimeOfDay(t){this.frames.setTimeOfDay((t%24+24)%24)}setSlice(t){const e=this.slice?.x===t?.x&&this.slice?.z===t?.z&&this.slice?.yaw===t?.yaw;this.slice=t,!e&&this.land.setSlice(t===null?null:{x:t.x,z:t.z,nx:Math.sin(t.yaw),nz:-Math.cos(t.yaw)})}setChunkBorders(t){this.frames.setBorders(t)}setSelection(t){this.selection=t}setRadius(t,e){t===this.radius&&e===this.horizon||(this.radius=t,this.horizon=e,this.info!==null&&this.makeGround(),this.viewSent.x=1/0)}setQuality(t){this.frames.setQuality(t)}setReducedMotion(t){this.reducedMotion=t}setToken(t){this.token=t,this.reconnect()}reconnect(){this.client.close(),this.setState("connecting",""),this.connect()}screenshot(){return new Promise((t,e)=>{this.wantsPicture.push(n=>n?t(n):e(new Error("the browser made no picture")))})}stats(){const t=performance.now(),e=this.latency.percentiles(.5,.95,.99),n=this.cpu.percentiles(.5,.95);return{state:this.state,chunks:this.land.held,chunksPerLevel:[...this.land.heldPerLevel],chunksWanted:this.chunksWanted,pendingMeshes:this.land.waiting,meshes:this.frames.terrain.meshes,triangles:this.frames.triangles,drawCalls:this.frames.drawCalls,receivedBytes:this.client.stats.receivedBytes,latency:e&&{p50:e[0],p95:e[1],p99:e[2]},chunkRate:this.rate.at(t),nearestMissing:this.land.nearestMissing(this.eye.x,this.eye.z),gpuBytes:this.frames.gpuBytes,heapBytes:this.pool.heldBytes+this.voxels.bytes+this.land.payloadBytes,frameCpu:{p50:n?.[0]??0,p95:n?.[1]??0},meshMs:this.pool.meanMs,firstFrameMs:this.firstFrameMs,completeMs:this.completeMs}}on(t,e){let n=this.handlers.get(t);return n===void 0&&this.handlers.set(t,n=new Set),n.add(e),()=>void n.delete(e)}dispose(){this.disposed||(this.disposed=!0,this.options.canvas.removeEventListener("webglcontextlost",this.onContextLost),this.options.canvas.removeEventListener("webglcontextrestored",this.onContextRestored),this.client.close(),this.pool.dispose(),this.frames.dispose())}connect(){const t=new URL(this.options.url);this.options.transport==="websocket"&&(t.protocol=t.protocol==="https:"?"wss:":"ws:");const e=lm({url:t.href,token:this.token,clientName:"talus-viewer",manualCredit:!0});this.client=e;const n=()=>e===this.client&&!this.disposed;e.on("connected",(s,r)=>n()&&this.onConnected(s,r)),e.on("chunk",s=>{if(!n())return;const{lod:r,x:a,y:o,z:l}=s.key;this.rate.add(performance.now()),this.land.add(r,a,o,l,s.payload,s.material),this.land.waiting<Qh?e.taken(s):this.untaken.push(s)}),e.on("chunkLeft",({lod:s,x:r,y:a,z:o})=>n()&&this.land.leave(s,r,a,o)),e.on("viewComplete",()=>{n()&&(this.viewComplete=!0)}),e.on("disconnected",(s,r)=>{n()&&r!==null&&this.setState("lost",s.message)}),e.on("error",s=>n()&&this.emit("error",s.message)),e.on("closed",s=>{n()&&s!==null&&this.setState(s.kind==="refused"?"refused":"lost",s.message)}),this.joined=e.ready(),this.joined.catch(()=>{})}onConnected(t,e){const n=this.info===null||!e||this.info.fingerprint!==t.fingerprint;n&&(this.info!==null&&(this.land.clear(),this.voxels.clear()),this.info={...t,seaLevel:null},this.seaLevel=null,this.prepareMaterials(t),this.makeGround(),this.viewSent.x===1/0&&this.eye.x===0&&this.eye.z===0&&(this.eye={...this.eye,x:t.spawn.x+.5,y:t.spawn.y+1.6,z:t.spawn.z+.5})),this.viewSent.x=1/0,this.setState("streaming",""),this.emit("world",this.world,!n)}prepareMaterials(t){const e=t.materials.slice(0,ZS),n=e.reduce((a,o)=>Math.max(a,o.id),0),s=new Uint8Array(n+1).fill(ja),r=new Uint16Array(65536);e.forEach((a,o)=>{s[a.id]=a.phase==="gas"?Yh:a.phase==="liquid"?Kh:ja,r[a.id]=o}),this.kinds=s,this.pool.setWorld(s,r),this.frames.setMaterials(lM(e))}makeGround(){const t=kh(this.info,this.eye,{x:0,y:0,z:0},this.radius,this.horizon).rings.length+1,e=Math.round((this.info.minY+this.info.maxY)/128)*64;this.groundBase=this.info.maxY-this.info.minY<4e3?0:e,this.frames.setGround(new KS(this.frames.renderer,this.radius,t,this.groundBase));for(const n of this.land.values())(n.heights!==null||n.liquids!==null)&&this.frames.ground.set(n)}groundBase=0;kindOf(t){const e=this.kinds[t]??ja;return e===Yh?"gas":e===Kh?"liquid":"solid"}seeSea(t,e){for(const n of t)if(!(n<=-32768)){this.seaLevel=n*2**e;return}}sendView(t){if(this.info===null||t-this.viewSent.at<_M)return;const{x:e,y:n,z:s,yaw:r,pitch:a}=this.eye,o=S=>Math.floor(S/32),l=this.viewSent,c=Math.abs(Math.atan2(Math.sin(r-l.yaw),Math.cos(r-l.yaw)))>Math.PI/6,h=!Number.isFinite(l.x)||o(e)!==o(l.x)||o(s)!==o(l.z)||o(n)!==o(l.y);if(!h&&!(c&&!this.complete))return;this.viewSent={x:e,y:n,z:s,yaw:r,at:t};const u={x:Math.sin(r)*Math.cos(a),y:Math.sin(a),z:-Math.cos(r)*Math.cos(a)},d=kh(this.info,this.eye,u,this.radius,this.horizon);try{this.client.setView(d)}catch(S){this.emit("error",S.message);return}if(!h)return;const f=DS(d,this.info);this.land.setShape(f),this.chunksWanted=NS(f),this.viewComplete=this.complete=!1,this.state==="complete"&&this.setState("streaming","");const _=S=>o(S)*32+16;this.frames.setReach(_(e),_(s),d.horizontalRadius*32,Math.min(this.horizon,32*(d.rings.at(-1)?.radius??d.horizontalRadius)))}takeBacklog(){for(;this.untaken.length>0&&this.land.waiting<Qh;)this.client.taken(this.untaken.shift())}settle(t){!this.viewComplete||this.complete||!this.land.settled||(this.complete=!0,this.completeMs??=t-this.started,this.state==="streaming"&&this.setState("complete",""))}draw(t){const{eye:e}=this;this.land.version!==this.drawnVersion&&(this.drawnVersion=this.land.version,this.frames.landChanged());const n=this.options.frozenTime??(this.reducedMotion?0:null),s=this.voxelAt(Math.floor(e.x),Math.floor(e.y),Math.floor(e.z)),r=this.land.get(0,Math.floor(e.x/32),Math.floor(e.z/32)),a=l=>(Math.floor(l)%32+32)%32,o=r?.heights?.[a(e.z)*32+a(e.x)]??-32768;this.frames.draw({eye:e,columns:this.nearestFirst(),seconds:n??t/1e3,now:performance.now(),slice:this.land.slice,selected:this.selection,seaLevel:this.seaLevel,underWater:s!==void 0&&this.isLiquid(s),hideBuried:this.land.slice===null&&e.y>o-4,groundBase:this.groundBase}),this.firstFrameMs===null&&this.frames.triangles>1&&(this.firstFrameMs=performance.now()-this.started);for(const l of this.wantsPicture.splice(0))this.options.canvas.toBlob(l,"image/png")}nearestFirst(){const{x:t,z:e}=this.eye;if(this.sorted.version!==this.land.version||Math.abs(t-this.sorted.x)+Math.abs(e-this.sorted.z)>32){const n=r=>{const a=32*2**r.lod;return Math.hypot((r.x+.5)*a-t,(r.z+.5)*a-e)-a/2},s=Array.from(this.land.drawn,r=>({column:r,at:n(r)}));s.sort((r,a)=>r.at-a.at),this.sorted={version:this.land.version,x:t,z:e,columns:s.map(r=>r.column)}}return this.sorted.columns}sorted={version:-1,x:0,z:0,columns:[]};setState(t,e){t===this.state&&e===""||(this.state=t,this.emit("state",t,e))}emit(t,...e){for(const n of this.handlers.get(t)??[])n(...e)}onContextLost=t=>{t.preventDefault(),this.lost=!0,this.emit("contextLost")};onContextRestored=()=>{this.lost=!1,this.frames.contextRestored(),this.land.loseMeshes(),this.info!==null&&this.makeGround(),this.complete=!1,this.emit("contextRestored")}}function vM(i){try{return new sM(i.canvas,i.quality)}catch(t){throw new Error(`this browser cannot draw the world: it needs WebGL 2 (${t.message})`)}}const xM=500,SM=15e3,jh=2e3,MM=6e3,tu=i=>/token|unauthori[sz]ed/i.test(i);class yM{constructor(t,e,n,s,r,a){this.stage=t,this.settings=e,this.server=n,this.tokens=s,this.isReduced=r,this.listener=a,addEventListener("online",()=>this.hurry()),document.addEventListener("visibilitychange",()=>{document.visibilityState==="visible"&&this.hurry()})}engine=null;began=0;#t=0;#e=0;#n=0;#i;#s;#r=null;#l=!1;async open(){this.#f(),this.#n=0;const t=++this.#t,e=await this.server.obstacle();if(t!==this.#t)return;if(e!==null)return this.#d(e);const n=document.createElement("canvas");n.id="view",this.stage.querySelector("canvas")?.remove(),this.stage.prepend(n);const{token:s}=this.tokens;let r;this.#s=setTimeout(()=>void this.#u(t),jh),this.began=performance.now();try{r=await Nl.create({canvas:n,url:this.server.base.replace(/\/$/,""),transport:this.settings.transport,...s===null?{}:{token:s},radius:this.settings.radius,horizon:this.settings.horizon,quality:this.settings.quality,reducedMotion:this.isReduced()})}catch(a){t===this.#t&&await this.#c(t,a instanceof Error?a.message:String(a));return}if(t!==this.#t){r.dispose();return}clearTimeout(this.#s),this.#e=0,this.#a(r)}hurry(){this.#i!==void 0?this.open():this.engine?.stats().state==="lost"&&this.engine.reconnect()}again(){if(this.engine===null)return void this.open();const{token:t}=this.tokens;t!==null&&this.engine.setToken(t),this.engine.reconnect()}#a(t){this.engine=t,t.on("state",(e,n)=>{e==="lost"?this.#o({kind:"away",text:n,retryAt:null}):e==="refused"?this.#o(tu(n)?{kind:"token",text:n}:{kind:"refused",text:n}):e!=="connecting"&&this.#o(null)}),t.on("world",e=>this.#h(e)),t.on("contextLost",()=>{this.#o({kind:"graphics-lost"}),this.#s=setTimeout(()=>void this.open(),MM)}),t.on("contextRestored",()=>{clearTimeout(this.#s),this.#o(null)}),this.listener.opened(t,this.#l),this.#l=!0,this.#o(null),this.#h(t.world)}#h(t){const e=this.#r!==null&&this.#r!==t.fingerprint;this.#r=t.fingerprint,e&&this.listener.worldChanged(t)}async#u(t){const e=await this.server.obstacle();t!==this.#t||this.engine!==null||(e?.kind==="away"?this.#o({kind:"away",text:e.text,retryAt:null}):this.settings.transport==="websocket"&&++this.#n>1&&this.#o({kind:"no-socket",text:"The server answers, but its WebSocket does not open."}),this.#s=setTimeout(()=>void this.#u(t),jh))}async#c(t,e){if(clearTimeout(this.#s),document.createElement("canvas").getContext("webgl2")===null)return this.#o({kind:"no-webgl",text:e});const n=await this.server.obstacle();t===this.#t&&this.#d(n??{kind:tu(e)?"token":"away",text:e})}#d({kind:t,text:e}){if(t==="token")return this.#o({kind:t,text:e});if(t!=="away")return this.#o({kind:"refused",text:e});const n=Math.min(SM,xM*2**this.#e++);this.#i=setTimeout(()=>void this.open(),n),this.#o({kind:t,text:e,retryAt:performance.now()+n})}#o(t){this.listener.trouble(t)}#f(){clearTimeout(this.#i),clearTimeout(this.#s),this.#i=void 0,this.engine!==null&&(this.listener.closing(),this.engine.dispose(),this.engine=null)}}const eu={KeyW:["forward",1],KeyS:["forward",-1],KeyD:["right",1],KeyA:["right",-1],Space:["up",1],KeyC:["up",-1],ArrowUp:["forward",1],ArrowDown:["forward",-1],ArrowRight:["turn",1],ArrowLeft:["turn",-1],KeyE:["turn",1],KeyQ:["turn",-1],PageUp:["tilt",1],PageDown:["tilt",-1]};function wM(i,t){return i instanceof HTMLElement?i.isContentEditable||/^(INPUT|SELECT|TEXTAREA)$/.test(i.tagName)?t!=="Escape":/^(BUTTON|A|SUMMARY)$/.test(i.tagName)&&(t==="Space"||t==="Enter"):!1}class EM{#t=new Set;constructor(t,e){addEventListener("keydown",n=>{if(n.code==="Tab"&&document.body.classList.add("tabs"),!(n.ctrlKey||n.altKey||n.metaKey||wM(n.target,n.code))&&!e()){if(n.code in eu)this.#t.add(n.code),n.preventDefault();else if(n.key==="Shift")this.#t.add("Shift");else if(!n.repeat){const s=t[n.code]??t[n.key];if(s===void 0)return;n.preventDefault(),s()}}}),addEventListener("pointerdown",()=>document.body.classList.remove("tabs")),addEventListener("keyup",n=>this.#t.delete(n.key==="Shift"?"Shift":n.code))}read(t){for(const e of this.#t){const n=eu[e];n!==void 0&&(t[n[0]]+=n[1])}for(const e of["forward","right","up","turn","tilt"])t[e]=Math.max(-1,Math.min(1,t[e]));this.#t.has("Shift")&&(t.fast=!0)}release(){this.#t.clear()}}const bM=4;class TM{constructor(t,e,n,s){this.canvas=t,this.settings=e,t.addEventListener("pointerdown",r=>{r.pointerType!=="mouse"||r.button!==0||(this.isLocked?n(t.clientWidth/2,t.clientHeight/2):this.#n={x:r.clientX,y:r.clientY,moved:!1})}),addEventListener("pointermove",r=>{r.pointerType==="mouse"&&(!this.isLocked&&this.#n===null||this.#n!==null&&(Math.hypot(r.clientX-this.#n.x,r.clientY-this.#n.y)>bM&&(this.#n.moved=!0),!this.#n.moved)||this.#i(r.movementX,r.movementY))}),addEventListener("pointerup",r=>{if(r.pointerType!=="mouse"||this.#n===null)return;const a=!this.#n.moved;this.#n=null,a&&(n(r.clientX,r.clientY),this.#s())}),t.addEventListener("wheel",r=>{r.preventDefault(),s(-Math.sign(r.deltaY))},{passive:!1})}#t=0;#e=0;#n=null;get isLocked(){return document.pointerLockElement===this.canvas}read(t){t.yaw+=this.#t,t.pitch+=this.#e,this.#t=this.#e=0}release(){this.#n=null,this.#t=this.#e=0}#i(t,e){const n=this.settings.sensitivity;this.#t+=t*n,this.#e-=e*n*(this.settings.invertLook?-1:1)}#s(){this.canvas.requestPointerLock()?.catch(()=>{})}}const yd=1e-4,Ti=i=>Math.floor(i+yd),Ai=i=>Math.ceil(i-yd)-1;function nu(i,t){for(let e=Ti(i.low[1]);e<=Ai(i.high[1]);++e)for(let n=Ti(i.low[2]);n<=Ai(i.high[2]);++n)for(let s=Ti(i.low[0]);s<=Ai(i.high[0]);++s)if(t(s,e,n))return!0;return!1}function AM(i,t,e,n){if(e===0)return 0;const[s,r]=t===0?[1,2]:t===1?[0,2]:[0,1],a=[0,0,0],o=l=>{for(a[t]=l,a[s]=Ti(i.low[s]);a[s]<=Ai(i.high[s]);++a[s])for(a[r]=Ti(i.low[r]);a[r]<=Ai(i.high[r]);++a[r])if(n(a[0],a[1],a[2]))return!0;return!1};if(e>0){const l=i.high[t];for(let c=Ai(l)+1;c<=Ai(l+e);++c)if(o(c))return Math.max(0,c-l)}else{const l=i.low[t];for(let c=Ti(l)-1;c>=Ti(l+e);--c)if(o(c))return Math.min(0,c+1-l)}return e}const Mr=.3,RM=1.8,iu=1.62,CM=5,LM=9,su=3.2,PM=27,ru=8.6,IM=1.02,DM=120,NM=80,UM=1/60,sl={slowest:2,usual:24,fastest:600},ms=Math.PI/180,yr=(i,t,e)=>i+(t-i)*e;class FM{constructor(t){this.stuffAt=t}position=[0,0,0];velocity=[0,0,0];yaw=0;pitch=0;mode="fly";flySpeed=sl.usual;onGround=!1;swimming=!1;waiting=!1;#t=0;get eye(){return[this.position[0],this.position[1]+iu-this.#t,this.position[2]]}place(t,e,n){this.position[0]=t,this.position[1]=e,this.position[2]=n,this.velocity.fill(0),this.#t=0}step(t,e){if(this.yaw=((this.yaw+e.yaw+e.turn*DM*t)%360+360)%360,this.pitch=Math.min(89.9,Math.max(-89.9,this.pitch+e.pitch+e.tilt*NM*t)),this.mode==="fly")return this.#n(t,e);const n=Math.max(1,Math.ceil(t/UM));for(let s=0;s<n;++s)this.#i(t/n,e)}rise(t){const e=this.position[1];for(let n=0;n<=t;++n)if(this.position[1]=n===0?e:Math.floor(e)+n,!nu(this.#h(),this.#u))return!0;return this.position[1]=e,!1}#e(t){const[e,n]=[Math.sin(this.yaw*ms),Math.cos(this.yaw*ms)],s=e*t.forward+n*t.right,r=-n*t.forward+e*t.right,a=Math.max(1,Math.hypot(s,r));return{x:s/a,z:r/a}}#n(t,e){const n=this.flySpeed*(e.fast?4:1),s=Math.cos(this.pitch*ms),r=this.#e({...e,forward:e.forward*s}),a=Math.sin(this.pitch*ms)*e.forward+e.up,o=[r.x*n,Math.max(-1,Math.min(1,a))*n,r.z*n],l=1-Math.exp(-t*9);for(const c of[0,1,2]){const h=yr(this.velocity[c],o[c],l);this.velocity[c]=Math.abs(h)<.001?0:h,this.position[c]+=this.velocity[c]*t}this.onGround=this.swimming=this.waiting=!1,this.#t=0}#i(t,e){if(this.#t*=Math.exp(-t*14),this.waiting=this.#d(),this.waiting){this.velocity.fill(0);return}if(nu(this.#h(),this.#u)&&!this.rise(64)){this.velocity.fill(0);return}const[n,s,r]=this.position;this.swimming=this.#c("liquid",n,s+.9,r);const a=this.swimming||this.#c("liquid",n,s+.3,r),o=this.#e(e),l=this.swimming?su*(e.fast?1.6:1):e.fast?LM:CM,c=1-Math.exp(-t*(this.swimming?5:this.onGround?16:4));this.velocity[0]=yr(this.velocity[0],o.x*l,c),this.velocity[2]=yr(this.velocity[2],o.z*l,c),this.swimming?this.#s(t,e):(this.velocity[1]=Math.max(-55,this.velocity[1]-PM*t),e.up>0&&this.onGround?this.velocity[1]=ru:e.up>0&&a&&this.velocity[1]<3&&(this.velocity[1]=3)),this.#r(t,a,e)}#s(t,e){const n=e.forward>0?Math.sin(this.pitch*ms)*e.forward:0,r=Math.max(-1,Math.min(1,e.up+n))*su+(e.up===0?-.6:0);this.velocity[1]=yr(this.velocity[1],r,1-Math.exp(-t*5))}#r(t,e,n){const s=this.velocity[1]*t,r=this.#a(1,s),a=this.onGround;this.onGround=s<0&&r>s,r!==s&&(this.velocity[1]=0);for(const o of[0,2]){const l=this.velocity[o]*t,c=this.#a(o,l);c!==l&&((this.onGround||a)&&this.#l(o,l-c)||(this.velocity[o]=0,e&&n.up>0&&(this.velocity[1]=ru)))}}#l(t,e){const n=[...this.position],s=this.#a(1,IM),r=this.#a(t,e);this.#a(1,-s);const a=this.position[1]-n[1];if(Math.abs(r)<Math.abs(e)*.5||a<.01||this.#d()){for(const o of[0,1,2])this.position[o]=n[o];return!1}return this.#t+=a,this.onGround=!0,this.velocity[1]<0&&(this.velocity[1]=0),!0}#a(t,e){const n=AM(this.#h(),t,e,this.#u);return this.position[t]+=n,n}#h(){const[t,e,n]=this.position;return{low:[t-Mr,e,n-Mr],high:[t+Mr,e+RM,n+Mr]}}#u=(t,e,n)=>{const s=this.stuffAt(t,e,n);return s==="solid"||s==="unknown"};#c(t,e,n,s){return this.stuffAt(Math.floor(e),Math.floor(n),Math.floor(s))===t}#d(){const[t,e,n]=this.position;return this.#c("unknown",t,e,n)||this.#c("unknown",t,e+iu,n)||this.#c("unknown",t,e-.5,n)}}const OM=()=>({forward:0,right:0,up:0,turn:0,tilt:0,yaw:0,pitch:0,fast:!1}),au=Math.PI/180;class kM{body=new FM((t,e,n)=>this.#n(t,e,n));#t=[];#e=null;hasMoved=!1;add(t){this.#t.push(t)}enter(t){this.#e=t}step(t){const e=OM();for(const n of this.#t)n.read(e);this.hasMoved||=e.forward!==0||e.right!==0||e.up!==0||e.turn!==0||e.tilt!==0||e.yaw!==0,this.body.step(t,e)}release(){for(const t of this.#t)t.release()}look(t){const[e,n,s]=this.body.eye;t.setCamera(e,n,s,this.body.yaw*au,this.body.pitch*au)}toggleMode(){const{body:t}=this;t.mode=t.mode==="walk"?"fly":"walk",t.velocity.fill(0)}changeSpeed(t){const e=this.body.flySpeed*1.25**t;this.body.flySpeed=Math.min(sl.fastest,Math.max(sl.slowest,e))}#n(t,e,n){const s=this.#e;if(s===null)return"unknown";if(e>=s.world.maxY)return"gas";if(e<s.world.minY)return"solid";const r=s.voxelAt(t,e,n);return r===void 0?"unknown":s.isSolid(r)?"solid":s.isLiquid(r)?"liquid":"gas"}}const to=56,BM=250,eo=8,zM=2;class GM{constructor(t,e,n,s,r){this.canvas=t,this.stick=e,this.settings=n,this.onPick=s,this.onFirst=r,t.addEventListener("pointerdown",a=>this.#s(a)),t.addEventListener("pointermove",a=>this.#r(a)),t.addEventListener("pointerup",a=>this.#l(a,!0)),t.addEventListener("pointercancel",a=>this.#l(a,!1))}#t=new Map;#e=0;#n=0;up=0;hold(t,e){const n=s=>r=>{r.preventDefault(),this.up=s};t.addEventListener("pointerdown",n(e));for(const s of["pointerup","pointercancel","pointerleave"])t.addEventListener(s,n(0))}read(t){const e=this.#i();if(e!==void 0){const[n,s]=[e.atX-e.x,e.atY-e.y],r=Math.hypot(n,s),a=Math.min(1,Math.max(0,r-eo)/(to-eo));a>0&&(t.right+=n/r*a,t.forward-=s/r*a,r>to*1.6&&(t.fast=!0))}t.up+=this.up,t.yaw+=this.#e,t.pitch+=this.#n,this.#e=this.#n=0}release(){this.#t.clear(),this.up=this.#e=this.#n=0,this.#a()}#i(){return[...this.#t.values()].find(t=>t.moves)}#s(t){if(t.pointerType==="mouse")return;this.onFirst(),this.canvas.setPointerCapture(t.pointerId);const e=t.clientX<innerWidth/2&&this.#i()===void 0,{clientX:n,clientY:s,timeStamp:r}=t;this.#t.set(t.pointerId,{x:n,y:s,began:r,moves:e,atX:n,atY:s,strayed:!1}),this.#a()}#r(t){const e=this.#t.get(t.pointerId);if(e!==void 0){if(!e.moves){const n=this.settings.sensitivity*zM;this.#e+=(t.clientX-e.atX)*n,this.#n-=(t.clientY-e.atY)*n*(this.settings.invertLook?-1:1)}e.atX=t.clientX,e.atY=t.clientY,Math.hypot(e.atX-e.x,e.atY-e.y)>eo&&(e.strayed=!0),this.#a()}}#l(t,e){const n=this.#t.get(t.pointerId);this.#t.delete(t.pointerId)&&(e&&n!==void 0&&!n.strayed&&t.timeStamp-n.began<BM&&this.onPick(n.x,n.y),this.#a())}#a(){const t=this.#i();if(this.stick.hidden=t===void 0,t===void 0)return;const[e,n]=[t.atX-t.x,t.atY-t.y],s=Math.max(1,Math.hypot(e,n)/to);this.stick.style.transform=`translate(${t.x}px, ${t.y}px)`,this.stick.firstElementChild.style.transform=`translate(${e/s}px, ${n/s}px)`}}const HM=.25,ou=20;class VM{constructor(t){this.turns=t}#t=0;#e=0;#n=0;#i=[];start(){const t=e=>{requestAnimationFrame(t),this.turns.step(e,Math.min(HM,Math.max(0,(e-this.#t)/1e3))),this.#t=e,this.#s();const n=this.turns.cap();n>0&&e-this.#e<1e3/n-1||(this.#e=e,this.#i.push(e),this.#i.length>60&&this.#i.shift(),this.turns.draw(e))};requestAnimationFrame(t),setInterval(()=>{performance.now()-this.#n>=ou&&this.#s()},ou)}#s(){this.turns.update(),this.#n=performance.now()}get framesPerSecond(){const[t,e]=[this.#i[0],this.#i.at(-1)];return t===void 0||e===void 0||e===t?0:(this.#i.length-1)*1e3/(e-t)}}const WM=500;class XM{#t=0;#e="";follow(t,e){t-this.#t>=WM&&this.write(e,t)}write(t,e=performance.now()){this.#t=e;const n=Vd(t,location.hash);n!==this.#e&&(this.#e=n,history.replaceState(history.state,"",n))}}const lu=(...i)=>t=>i.includes(t),wr=(i,t)=>e=>typeof e=="number"&&e>=i&&e<=t,Er=i=>typeof i=="boolean",rl={radius:wr(2,24),horizon:wr(0,16384),quality:lu("low","high"),transport:lu("websocket","http"),frameRate:wr(0,240),sensitivity:wr(.02,1),invertLook:Er,timeRuns:Er,chunkBorders:Er,reducedMotion:i=>i===null||Er(i)};function wd(i){return{radius:i?6:10,horizon:i?2048:4096,quality:i?"low":"high",transport:"websocket",frameRate:0,sensitivity:.12,invertLook:!1,timeRuns:!1,chunkBorders:!1,reducedMotion:null}}function Ul(i,t){const e={...i};if(typeof t=="object"&&t!==null)for(const[n,s]of Object.entries(t))n in rl&&rl[n](s)&&(e[n]=s);return e}function qM(i){const t={};for(const[e,n]of new URLSearchParams(i.replace(/^#/,"")))e in rl&&(t[e]=n==="true"?!0:n==="false"?!1:/^\d+(\.\d+)?$/.test(n)?Number(n):n);return t}const Ed="talus.settings";function $M(i,t){try{return Ul(i,JSON.parse(t().getItem(Ed)??"null"))}catch{return i}}function YM(i,t){try{t().setItem(Ed,JSON.stringify(i))}catch{}}const gs=60,yn=i=>Math.round(i).toLocaleString("en");function br(i){if(i<1e3)return`${Math.round(i)} B`;for(const t of["kB","MB","GB"])if(i/=1e3,i<1e3||t==="GB")return`${i<10?i.toFixed(2):i<100?i.toFixed(1):Math.round(i)} ${t}`;return""}const _s=i=>i<10?i.toFixed(1):String(Math.round(i)),KM={connecting:"connecting",streaming:"streaming",complete:"complete",lost:"server away",refused:"refused"};class ZM{#t=new Map;#e=[];#n=0;#i=0;#s=0;update(t,e,n,s){const r=Math.floor(e/1e3);if(r!==this.#n&&(this.#n=r,this.#s=Math.max(0,t.receivedBytes-this.#i),this.#i=t.receivedBytes,this.#e.push(t.chunkRate),this.#e.length>gs&&this.#e.shift()),!s)return;const{latency:a,frameCpu:o}=t;this.#r("View",KM[t.state]),this.#r("Chunks",`${yn(t.chunks)}, ${yn(t.chunkRate)} /s`),this.#r("Received",`${br(t.receivedBytes)}, ${br(this.#s)}/s`),this.#r("Asked to drawn, p50",a===null?"–":`${_s(a.p50)} ms`),this.#r("p95, p99",a===null?"–":`${_s(a.p95)}, ${_s(a.p99)} ms`),this.#r("Land is missing",t.nearestMissing===null?"nowhere":`${yn(t.nearestMissing)} blocks away`),this.#r("Meshes, to come",`${yn(t.meshes)}, ${yn(t.pendingMeshes)}`),this.#r("Triangles",yn(t.triangles)),this.#r("Draw calls",yn(t.drawCalls)),this.#r("Pictures a second",n.toFixed(0)),this.#r("Frame, p50, p95",`${_s(o.p50)}, ${_s(o.p95)} ms`),this.#r("On the card, in the page",`${br(t.gpuBytes)}, ${br(t.heapBytes)}`),this.#l(),this.#a(t.chunksPerLevel)}#r(t,e){let n=this.#t.get(t);n===void 0&&(n=wi("dd"),this.#t.set(t,n),Mt("traffic").append(wi("dt",t),n)),fe(n,e)}#l(){const t=Math.max(1,...this.#e),e=this.#e.map((s,r)=>`${(r+gs-this.#e.length)*(120/(gs-1))} ${30-s/t*28}`);if(e.length<2)return;const n=(gs-this.#e.length)*(120/(gs-1));Mt("traffic-chart").querySelector(".line").setAttribute("d",`M${e.join("L")}`),Mt("traffic-chart").querySelector(".area").setAttribute("d",`M${n} 32L${e.join("L")}L120 32z`)}#a(t){const e=Mt("traffic-levels"),n=Math.max(1,...t);for(;e.childElementCount<t.length;){const s=wi("li"),r=e.childElementCount;s.append(wi("span",r===0?"Full detail":`1 : ${2**r}`),wi("meter"),wi("span")),e.append(s)}t.forEach((s,r)=>{const[a,o,l]=e.children[r].children;o.max=n,o.value=s,o.setAttribute("aria-label",`${a.textContent}: ${s} chunks`),fe(l,yn(s))})}}function bd(i){if(i.state==="complete")return 1;const t=i.chunks+i.pendingMeshes;return t===0?null:Math.min(.99,i.chunks/t)}class JM{#t=Mt("opening");#e=Mt("hint");constructor(t){Mt("hint-close").addEventListener("click",()=>{this.#e.hidden=!0,t()})}opening(t,e){fe(Mt("opening-text"),t);const n=Mt("opening-progress");e===null?n.removeAttribute("value"):n.value=e}opened(){this.#t.classList.add("gone"),this.#t.removeAttribute("role")}hint(t){this.#e.hidden=!t}status(t,e){fe(Mt("status-text"),t),Mt("status").dataset.state=e}connection(t){if(t.state==="lost")return this.status("Server away","bad");if(t.state==="refused")return this.status("Refused","bad");if(t.state==="connecting")return this.status("Connecting","busy");if(t.state==="complete")return this.status("All here","good");const e=bd(t);this.status(e===null?"Receiving":`Receiving ${Math.floor(e*100)} %`,"busy")}where(t,e){const[n,s,r]=[t.x,t.y??0,t.z].map(o=>yn(Math.floor(o)));fe(Mt("where-at"),`${n}, ${s}, ${r}`);const a=e.waiting?"waiting for the land":e.mode==="fly"?`flying ${ec(t.yaw)}, ${yn(e.flySpeed)} blocks/s`:`${e.swimming?"swimming":"walking"} ${ec(t.yaw)}`;fe(Mt("where-how"),a)}}class QM{constructor(t){this.answers=t}#t=Mt("notice");#e=Mt("notice-text");#n=null;#i="";trouble(t){if(this.#n=null,t===null){this.#t.dataset.kind!=="world"&&this.hide();return}switch(t.kind){case"away":this.#i=t.text,this.#n=t.retryAt,this.#s("away","The server is away","",[["Try now",this.answers.retry]]),this.tick(performance.now());break;case"token":this.#s("token","The server asks for a token",t.text,[["Give a token",()=>this.answers.askToken(t.text)]]),this.answers.askToken(t.text);break;case"refused":this.#s("refused","The server refuses",t.text,[["Try again",this.answers.again]]);break;case"no-socket":this.#s("no-socket","The land does not come",t.text,[["Take it by HTTP",this.answers.byHttp],["Try again",this.answers.reload]]);break;case"no-webgl":this.#s("no-webgl","This browser shows no 3D here",`It needs WebGL 2: ${t.text} The map works without.`,[["Open the map",()=>location.assign("map.html"+location.hash)],["Try again",this.answers.reload]]);break;case"graphics-lost":this.#s("graphics-lost","The system took the graphics away","The picture comes back in a moment.",[["Now",this.answers.reload]])}}worldChanged(){this.#s("world","This is another world now","The server has a new one. You stand at the same coordinate in it.",[["Go to its spawn",()=>(this.answers.toSpawn(),this.hide())],["Stay",()=>this.hide()]])}hide(){this.#t.hidden=!0,delete this.#t.dataset.kind}tick(t){if(this.#t.dataset.kind!=="away")return;const e=this.#n===null?null:Math.max(0,Math.ceil((this.#n-t)/1e3)),n=e===null||e===0?"Trying again.":`Trying again in ${e} s.`,s=this.#i===""?"":cu(this.#i)+" ";fe(this.#e,s+n)}#s(t,e,n,s){this.#t.dataset.kind=t,fe(Mt("notice-title"),e),fe(this.#e,n===""?"":cu(n)),Mt("notice-actions").replaceChildren(...s.map(([r,a])=>{const o=wi("button",r);return o.type="button",o.addEventListener("click",a),o})),this.#t.hidden=!1}}const cu=i=>i.charAt(0).toUpperCase()+i.slice(1)+(/[.!?]$/.test(i)?"":".");class jM{constructor(t){this.giveBackFocus=t;for(const e of document.querySelectorAll("[data-panel]")){const n=e.dataset.panel;this.#e.set(n,e),e.setAttribute("aria-expanded","false"),e.setAttribute("aria-controls",`panel-${n}`),e.addEventListener("click",()=>this.toggle(n))}}#t=null;#e=new Map;onOpen=new Map;isOpen(t){return this.#t===t}toggle(t,e=!0){const n=this.#t!==t;if(this.close(!1),!n)return this.giveBackFocus();this.#t=t;const s=Mt(`panel-${t}`);s.hidden=!1,this.#e.get(t).setAttribute("aria-expanded","true"),document.exitPointerLock?.(),this.onOpen.get(t)?.(),e&&s.querySelector("input, button, select")?.focus({preventScroll:!0})}close(t=!0){return this.#t===null?!1:(Mt(`panel-${this.#t}`).hidden=!0,this.#e.get(this.#t).setAttribute("aria-expanded","false"),this.#t=null,t&&this.giveBackFocus(),!0)}}const hu={radius:({radius:i})=>`${i} chunks`,horizon:({horizon:i})=>i===0?"none":`${(i/1e3).toFixed(1)} km`,sensitivity:({sensitivity:i})=>`${Math.round(i*100)}`};class ty{constructor(t,e,n){this.settings=t,this.#t.addEventListener("submit",s=>s.preventDefault()),this.#t.addEventListener("input",s=>{const r=s.target,a=r instanceof HTMLInputElement&&r.type==="checkbox"?String(r.checked):r.value,o=a==="null"?null:a==="true"?!0:a==="false"?!1:Number.isNaN(Number(a))?a:Number(a),l=Ul(t,{[r.name]:o}),c=r.name;l[c]!==t[c]&&e({[c]:l[c]}),this.show()}),Mt("settings-reset").addEventListener("click",()=>{e(wd(n)),this.show()}),this.show()}#t=Mt("settings");show(){for(const[t,e]of Object.entries(this.settings)){const n=this.#t.elements.namedItem(t);n instanceof HTMLInputElement&&n.type==="checkbox"?n.checked=e:(n instanceof HTMLInputElement||n instanceof HTMLSelectElement)&&(n.value=String(e)),t in hu&&fe(Mt(`${t}-now`),hu[t](this.settings))}}}class ey{constructor(t,e,n){this.picture=t,this.place=e,Mt("save-picture").addEventListener("click",()=>void this.save()),Mt("copy-link").addEventListener("click",async()=>{n();try{await navigator.clipboard.writeText(location.href),this.#t("The link is copied.")}catch{this.#t("This browser does not let the page copy; the address above is the link.")}})}async save(){const t=this.picture();if(t===null)return this.#t("There is no picture yet.");const e=URL.createObjectURL(await t),{x:n,z:s}=this.place(),r=document.createElement("a");r.href=e,r.download=`talus_${Math.round(n)}_${Math.round(s)}.png`,r.click(),URL.revokeObjectURL(e),this.#t(`Saved as ${r.download}.`)}#t(t){fe(Mt("share-said"),t)}}const ny=24;function uu(i,t){const e=i.yaw*Math.PI/180;return{x:i.x+Math.sin(e)*t,z:i.z-Math.cos(e)*t,yaw:e+Math.PI}}class iy{constructor(t,e){this.standNow=t,this.apply=e,this.#t.addEventListener("change",()=>this.#t.checked?this.cutHere():this.#s()),this.#e.addEventListener("input",()=>this.#s()),this.#n.addEventListener("input",()=>{const{x:n,z:s}=uu(this.#i,Number(this.#e.value));this.#i={x:n,z:s,yaw:Number(this.#n.value)},this.#e.value="0",this.#s()}),Mt("slice-here").addEventListener("click",()=>this.cutHere()),this.#s()}#t=Mt("slice-on");#e=Mt("slice-distance");#n=Mt("slice-yaw");#i={x:0,z:0,yaw:0};get slice(){return this.#t.checked?uu(this.#i,Number(this.#e.value)):null}cutHere(){const{x:t,z:e,yaw:n}=this.standNow();this.#i={x:t,z:e,yaw:Math.round(Wd(n))%360},this.#e.value=String(ny),this.#n.value=String(this.#i.yaw),this.#t.checked=!0,this.#s()}off(){this.#t.checked=!1,this.#s()}move(t){if(!this.#t.checked)return this.cutHere();this.#e.value=String(Number(this.#e.value)+t),this.#s()}#s(){fe(Mt("slice-distance-now"),`${this.#e.value} blocks`),fe(Mt("slice-yaw-now"),`${this.#n.value}°`),this.apply(this.slice)}}const du=256,Td=70,vs=Math.PI/180;function Ad(i,t,e,n){const s=Math.tan(Td/2*vs),[r,a]=[Math.sin(i*vs),Math.cos(i*vs)],[o,l]=[Math.sin(t*vs),Math.cos(t*vs)],[c,h]=[e*s,n*s],u=l-h*o,[d,f,_]=[r*u+a*c,o+h*l,-a*u+r*c],S=Math.hypot(d,f,_);return{x:d/S,y:f/S,z:_/S}}class sy{#t=Mt("voxel");#e=Mt("voxel-close");#n=null;#i=null;constructor(){this.#e.addEventListener("click",()=>this.letGo())}get held(){return this.#n}get shown(){return this.#i}look(t,e,n,s){this.#n===null&&this.#s(t,t.raycast(e,Ad(n,s,0,0),du,!0))}hold(t,e,n){this.#n=t.raycast(e,n,du,!0),this.#e.hidden=this.#n===null,this.#s(t,this.#n)}letGo(){const t=this.#n!==null;return this.#n=null,this.#e.hidden=!0,t}clear(){this.letGo(),this.#i=null,this.#t.hidden=!0}#s(t,e){if(!(e!==null&&this.#i!==null&&e.x===this.#i.x&&e.y===this.#i.y&&e.z===this.#i.z&&e.material===this.#i.material)&&(e!==null||this.#i!==null)&&t.setSelection(e),this.#i=e,this.#t.hidden=e===null,e===null)return;const s=t.world.materials.find(({id:r})=>r===e.material);fe(Mt("voxel-name"),s?.name??`material ${e.material}`),fe(Mt("voxel-at"),`${e.x}, ${e.y}, ${e.z}`),Mt("voxel-colour").style.background="#"+(s?.colour??0).toString(16).padStart(6,"0"),this.#t.dataset.material=String(e.material)}}const Fl=matchMedia("(pointer: coarse)").matches,Rd=matchMedia("(prefers-reduced-motion: reduce)"),Cd=()=>localStorage,ry=1440,ay=-8,Ld=14;let Fr=$M(wd(Fl),Cd);const Ce=Ul(Fr,qM(location.hash)),al=()=>Ce.reducedMotion??Rd.matches,Ol=new Xd,kl=new qd(location.href,()=>Ol.token),ze=new kM,{body:ce}=ze,Pd=new XM,Cn=Mt("stage");let ae=null,An=dl(location.hash).time??10.5,Hn=!1;function Ds(){const[i,t,e]=ce.position;return{x:i,y:t,z:e,yaw:ce.yaw,pitch:ce.pitch,time:An,mode:ce.mode}}async function Bl(i,t,e){let n=t;n===null&&(n=Math.max(await kl.ground(i,e),ae?.world.seaLevel??-1/0)+(ce.mode==="fly"?Ld:0)),ce.place(i,n,e),Hn=!0}function Zr(){if(ae===null)return;const{x:i,y:t,z:e}=ae.world.spawn;ce.place(i+.5,t+(ce.mode==="fly"?Ld:0),e+.5),Hn=!0}function Id(i){ce.mode=i.mode??ce.mode,ce.yaw=i.yaw??ce.yaw,ce.pitch=i.pitch??ce.pitch,i.time!==void 0&&es(i.time),i.x!==void 0&&i.z!==void 0?Bl(i.x,i.y??null,i.z).catch(t=>{nn.status(t.message,"bad"),Hn||Zr()}):Hn||Zr()}addEventListener("hashchange",()=>Id(dl(location.hash)));const ol=Mt("time"),Jr=Mt("time-runs");function es(i){An=Kd(i),ae?.setTimeOfDay(An),ol.value=String(An),fe(Mt("time-now"),Zd(An))}ol.addEventListener("input",()=>es(Math.min(23.99,Number(ol.value))));Jr.checked=Ce.timeRuns;Jr.addEventListener("change",()=>ks({timeRuns:Jr.checked}));function ks(i){Object.assign(Ce,i),Fr={...Fr,...i},YM(Fr,Cd),"transport"in i&&Ci.open(),("radius"in i||"horizon"in i)&&ae?.setRadius(Ce.radius,Ce.horizon),"quality"in i&&(ae?.setQuality(Ce.quality),Hl()),"reducedMotion"in i&&sa(),"chunkBorders"in i&&zl(),Jr.checked=Ce.timeRuns}function sa(){ae?.setReducedMotion(al()),document.body.classList.toggle("still",al())}Rd.addEventListener("change",sa);const ll=Mt("borders");function zl(){ll.checked=Ce.chunkBorders,ae?.setChunkBorders(Ce.chunkBorders)}ll.addEventListener("change",()=>ks({chunkBorders:ll.checked}));const Bs=()=>Cn.focus({preventScroll:!0}),kn=new jM(Bs),nn=new JM(Bs),oy=new ZM,Ri=new sy,Yi=new iy(()=>({x:ce.position[0],z:ce.position[2],yaw:ce.yaw}),i=>ae?.setSlice(i));new ty(Ce,ks,Fl);new ey(()=>ae?.screenshot()??null,Ds,()=>Pd.write(Ds()));const Dd=new $d(Ol,()=>Ci.again());Mt("token-change").addEventListener("click",()=>Dd.ask("The next connection uses it."));const Gl=Mt("help"),cl=()=>{document.exitPointerLock?.(),Gl.showModal()};Mt("open-help").addEventListener("click",cl);Gl.addEventListener("close",Bs);Mt("goto-form").addEventListener("submit",i=>{i.preventDefault();const t=Yd(Mt("goto-text").value),e=Mt("goto-wrong");if(t===null)return fe(e,"Two or three numbers, such as 1200 -340 or 1200 90 -340.");fe(e,""),Bl(t.x,t.y,t.z).then(()=>kn.close(),n=>fe(e,n.message))});Mt("goto-spawn").addEventListener("click",()=>(Zr(),kn.close()));const hl=new QM({retry:()=>Ci.hurry(),again:()=>Ci.again(),reload:()=>void Ci.open(),byHttp:()=>ks({transport:"http"}),askToken:i=>Dd.ask(i),toSpawn:Zr}),Ci=new yM(Cn,Ce,kl,Ol,al,{opened(i){ae=i,ze.enter(i),i.setFov(Td),Hl(),i.setTimeOfDay(An),i.setSlice(Yi.slice),sa(),zl(),Hn||Id(ly()),nn.opening("The land is on its way",null),fe(Mt("help-world"),`${i.world.server}, world ${i.world.fingerprint}`)},closing(){ae=null,ze.enter(null),Ri.clear()},trouble(i){if(hl.trouble(i),i===null)return;const t={away:"Server away",token:"No access",refused:"Refused","no-socket":"No connection","no-webgl":"No 3D","graphics-lost":"No graphics"};nn.status(t[i.kind],"bad"),i.kind==="away"?nn.opening("Waiting for the server",null):nn.opened()},worldChanged(i){Ri.clear(),fe(Mt("help-world"),`${i.server}, world ${i.fingerprint}`),hl.worldChanged()}});function ly(){const i=dl(location.hash);return{pitch:ay,mode:"fly",...i}}function Hl(){const i=Math.min(devicePixelRatio,Ce.quality==="high"?2:1);ae?.resize(Cn.clientWidth,Cn.clientHeight,i)}addEventListener("resize",Hl);const Nd=()=>{const[i,t,e]=ce.eye;return{x:i,y:t,z:e}};function ra(i,t){if(ae===null)return;const e=Cn.clientHeight/2,n=Ad(ce.yaw,ce.pitch,(i-Cn.clientWidth/2)/e,1-t/e);Ri.hold(ae,Nd(),n)}const cy=()=>ra(Cn.clientWidth/2,Cn.clientHeight/2),ul=i=>ze.changeSpeed(i),hy={KeyF:()=>ze.toggleMode(),KeyM:()=>Ud(),KeyG:()=>kn.toggle("goto"),KeyT:()=>kn.toggle("time"),KeyX:()=>Yi.slice===null?Yi.cutHere():Yi.off(),BracketLeft:()=>Yi.move(-1),BracketRight:()=>Yi.move(1),KeyP:()=>kn.toggle("traffic",!1),KeyB:()=>ks({chunkBorders:!Ce.chunkBorders}),KeyK:()=>kn.toggle("share"),KeyO:()=>kn.toggle("settings"),KeyU:()=>document.body.classList.toggle("bare"),KeyH:cl,"?":cl,Home:()=>ce.pitch=0,Comma:()=>es(An-.25),Period:()=>es(An+.25),"+":()=>ul(1),"-":()=>ul(-1),Enter:()=>Ri.held===null?cy():Ri.letGo(),Escape:()=>kn.close()||Ri.letGo()},uy=()=>Gl.open||Mt("token").open||!Mt("map").hidden;ze.add(new EM(hy,uy));ze.add(new TM(Cn,Ce,ra,ul));const Vl=new GM(Cn,Mt("stick"),Ce,ra,()=>{document.body.classList.add("touched"),Mt("thumbs").hidden=!1});Vl.hold(Mt("thumb-up"),1);Vl.hold(Mt("thumb-down"),-1);Mt("thumb-mode").addEventListener("click",()=>ze.toggleMode());ze.add(Vl);Fl&&(document.body.classList.add("touched"),Mt("thumbs").hidden=!1);addEventListener("blur",()=>ze.release());async function Ud(){document.exitPointerLock?.(),ze.release();const{openMapOverlay:i}=await jd(async()=>{const{openMapOverlay:t}=await import("./overlay-dZZ7W0tc.js");return{openMapOverlay:t}},__vite__mapDeps([0,1,2,3]),import.meta.url);i(Mt("map"),kl,{place:Ds,world:()=>ae?.world??null,go:(t,e)=>Bl(t,null,e),closed:Bs})}Mt("open-map").addEventListener("click",()=>void Ud());let fu=0,pu=0;const Fd=new VM({cap:()=>Ce.frameRate,step(i,t){Ce.timeRuns&&es(An+t*24/ry),Hn&&ze.step(t),ae!==null&&Hn&&(ze.look(ae),i-pu>100&&(pu=i,Ri.look(ae,Nd(),ce.yaw,ce.pitch)),Pd.follow(i,Ds())),i-fu>250&&(fu=i,fy(i))},update(){ae!==null&&Hn&&ae.update()},draw(i){ae!==null&&Hn&&ae.frame(i)}});function dy(i){const t=[["talus:first",i.firstFrameMs],["talus:complete",i.completeMs]];for(const[e,n]of t)n!==null&&performance.getEntriesByName(e).length===0&&performance.mark(e,{startTime:Ci.began+n})}function fy(i){if(hl.tick(i),ae===null)return;const t=ae.stats();dy(t),nn.connection(t),nn.where(Ds(),ce),t.meshes>0?nn.opened():nn.opening("The land is on its way",bd(t)),nn.hint(Od&&!ze.hasMoved),oy.update(t,i,Fd.framesPerSecond,kn.isOpen("traffic"))}let Od=!0;Mt("hint-close").addEventListener("click",()=>Od=!1);es(An);sa();zl();nn.opening("Connecting",null);nn.status("Connecting","busy");Bs();Fd.start();Ci.open();window.talus={get engine(){return ae},player:ze,settings:Ce,pick:ra};
