import{T as z,o as l0}from"./uniform-dDORJD-b.js";const h0={empty:"has no bytes; it needs at least a version and an encoding",unknown_version:"begins with a byte that is no version known here, 3 or 4",unknown_encoding:"has a second byte that names no encoding of its version",truncated:"ends before the chunk does; it must be passed whole",too_long:"goes on after the chunk's end; it must be passed without other bytes",bad_materials:"has a list of materials that is empty, too long or out of order",bad_number:"holds a number that is past its range or not in its shortest form",bad_ending:"does not end as its chunk does; it was changed on its way",bad_hash:"decodes to voxels that do not have the hash it came with"};class p extends z{constructor(a){super("bad_chunk",`the chunk payload ${h0[a]}`),this.fault=a}}const f0=32,ma=16,ba=f0/4,Ha=0,Ya=2,Za=4,G=6,Ka=0,Ja=6,la=8,Ma=10,Qa=12,ha=14,V=16,a0=18,t0=22,e0=24,ta=[Ka,Ja,la,Ma,Qa,ha,V,a0,t0,e0].reduce((i,a)=>i|3<<a,0),da=2,ua=4,s0=20,Y=26,Ra=28,Na=[[a0,Ja],[Ra,Ma],[ha,la],[Qa,e0],[Y,Ka],[t0,Ma],[ha,V],[la,V],[Ra,V],[ha,da],[la,ua],[V,da],[V,ua]],C=16843009,Oa=2139062143,Ba=-2139062144,fa=(i,a)=>{const t=(i|Ba)-a>>>7&C,s=(a|Ba)-i>>>7&C;return t+(s^C)},ea=1<<Ha|1<<Ya,Ua=3<<Za,sa=3<<Y|3<<Ra;class d0{even=new Int32Array(ma);odd=new Int32Array(ma);make(a,t,s,e,o,n){const{even:r,odd:c}=this,h=n<<s0;let l=a[t],f=l<<24,w=0,d=0,u=0;for(let y=0;y<=ba;y=y+1|0){let b=ea|w>>>24&Ua|ea<<8,g=0;if(y<ba){const x=y<ba-1?a[t+y+1|0]:Math.imul(l>>>24,C),T=a[s+y|0],A=fa(l,l<<8|f>>>24),E=fa(l>>>16|x<<16,l),m=l-T,I=(m+Oa>>>7&C)+(m+Oa-C>>>7&C);b=o[y]<<Ha|A<<Ya|I<<Za,g=E|fa(a[e+y|0],T)<<2,f=l,l=x}if(y===0)u=ea<<G|ea|b&Ua,u=u<<G|b&255,u=u<<G|b>>>8&255;else{const x=(y<<1)-2;u=u<<G|w>>>16&255,r[x]=u&ta|d<<Y&sa|h,u=u<<G|w>>>24,c[x]=u&ta|d<<Y-8&sa|h,u=u<<G|b&255,r[x+1]=u&ta|d<<Y-16&sa|h,u=u<<G|b>>>8&255,c[x+1]=u&ta|d<<Y-24&sa|h}w=b,d=g}}addSymbols(a){const{odd:t}=this;let s=a[0];for(let e=0;e<ma;e=e+2|0){const o=a[(e>>1)+1];t[e]=t[e]|(s&3)<<da|(s>>>16&3)<<ua,t[e+1]=t[e+1]|(s>>>16&3)<<da|(o&3)<<ua,s=o}}}const k=16,ga=256,u0=2*k,Pa=65538,w0=4096;class y0{bytes=new Uint8Array(Pa+w0);states=new Int32Array(k);next=0;end=0;begin(a){this.bytes.set(a),this.next=2,this.end=a.length}left(){return this.end-this.next}number(){let a=0;for(let t=0;t<=14;t+=7){if(this.next>=this.end)throw new p("truncated");const s=this.bytes[this.next++];if(a|=(s&127)<<t,!(s>=128)){if(s===0&&t>0||a>65535)break;return a}}throw new p("bad_number")}materials(a){const t=this.number();if(t===0||t>a)throw new p("bad_materials");const s=[];for(let e=0;e<t;++e)s.push(this.number());return s}takeStates(){if(this.left()<u0)throw new p("truncated");for(let a=0;a<k;++a){const t=this.bytes[this.next]|this.bytes[this.next+1]<<8;if(t<ga)throw new p("bad_ending");this.states[a]=t,this.next+=2}}read(a,t){let s=this.states[t];const e=a[s&255];return s=(e>>>16)*(s>>8)+(s&255)-(e>>8&255),s<ga&&(s=s<<8|this.bytes[this.next++]),this.states[t]=s,e&255}checkRead(){if(this.next>this.end)throw new p("truncated")}checkAllRead(){if(this.next!==this.end)throw new p("too_long")}checkFinalStates(){for(let a=0;a<k;++a)if(this.states[a]!==ga)throw new p("bad_ending")}}function ya(i,a){let t=0;for(let s=0;s<a.length;++s){const e=a[s];if(t+e>256)throw new p("bad_number");i.fill(s|t<<8|e<<16,t,t+e),t+=e}if(t!==256)throw new p("bad_number")}const m0=[23,41,65,96,118,143,167,193,209,227,243,246,250,253,252,253],b0=[250,253,253,252,254,254,255,255,254,255,255,255,255,255,255,255],g0=[1,10,11,26,44,55,75,121,145,171,194,228,235,245,253,255],S0=[`41 52 53 40 54 68 55 40 53 54 47 40 40 40 40 40
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
0 0 0 0 1 0 0 0 0 0 0 0 0 0 0 0`],A0=Uint8Array.from(Na,([i])=>i),p0=Uint8Array.from(Na,([,i])=>i),x0=s0,T0=9,H=16;function k0(i){const a=i.trim().split(/\s+/).map(Number);return Int32Array.from({length:a.length/2},(t,s)=>{const e=s>>4<<5|s&15;return a[e]<<16|a[e+16]&65535})}const n0=16,q=32-n0,F=(1<<q)-1,Sa=1<<31,Z=-1640531535,ja=16;class za{cache=new Int32Array(1<<n0).fill(Sa);weights;pairs;constructor(a){this.weights=S0.filter((t,s)=>s%2===1===a).map(k0),this.pairs=a?Na.length:T0}look(a,t){const{cache:s}=this;let e=0,o=0,n=0;for(let r=0;r<ja;r=r+4|0)o=Math.imul(a[r],Z),n=s[o>>>q],e|=n^o&F,t[r]=n>>>q<<8,o=Math.imul(a[r+1],Z),n=s[o>>>q],e|=n^o&F,t[r+1]=n>>>q<<8,o=Math.imul(a[r+2],Z),n=s[o>>>q],e|=n^o&F,t[r+2]=n>>>q<<8,o=Math.imul(a[r+3],Z),n=s[o>>>q],e|=n^o&F,t[r+3]=n>>>q<<8;(e&(F|Sa))!==0&&this.fill(a,t)}fill(a,t){const{cache:s}=this;for(let e=0;e<ja;++e){const o=Math.imul(a[e],Z);let n=s[o>>>q];((n^o&F)&(F|Sa))!==0&&(n=this.classOf(a[e])<<q|o&F,s[o>>>q]=n),t[e]=n>>>q<<8}}classOf(a){const{pairs:t}=this,s=this.weights[a>>>x0&3];let e=0,o=0;for(let n=0;n<t;n=n+1|0){const r=s[n<<4|a>>>A0[n]&3|(a>>>p0[n]&3)<<2];e=Math.max(-128,Math.min(127,e+(r>>16)|0)),o=Math.max(-128,Math.min(127,o+(r<<16>>16)|0))}return(Math.max(e,0)>>3)*H+(Math.max(o,0)>>3)}}function v0(){const i=new Int32Array(H*H<<8);for(let a=0;a<H;++a){const t=m0[a],s=b0[a];for(let e=0;e<H;++e){const o=t+1+((s-t-2)*g0[e]>>8),n=a*H+e<<8;ya(i.subarray(n,n+256),[t,o-t,s-o,256-s])}}return i}const v=32,P=v*v,D=64,E0=k,Aa=0,_0=1,K=2,J=v/4,B=16843009,pa=2139062143,Q=-2139062144;class I0{even=new za(!1);odd=new za(!0);slots=v0();planes=new Uint8Array(P*D+v);planeWords=new Int32Array(this.planes.buffer);keys=new d0;intervals=new Int32Array(k);symbols=new Uint8Array(v+4);symbolWords=new Int32Array(this.symbols.buffer);stepSigns=new Int32Array(J);stepSignBytes=new Uint8Array(this.stepSigns.buffer);firstOfHeight=new Int32Array(v+1);nextOfHeight=new Int32Array(P*D);ids=[];decode(a){const t=a.next,s=a.number(),e=s>D+1&&s<=D+k;let o=[];if(!e&&(a.next=t,o=a.materials(D),Wa(o),o.length===1))return a.checkAllRead(),o[0];const n=(e?s-D:o.length)-1;a.takeStates();for(let r=1;r<=n;++r)this.readPlane(a,r*P);return a.checkAllRead(),e?(o=R0(a,n+1),Wa(o)):a.checkFinalStates(),this.ids=o,null}readPlane(a,t){const s=M0(a);this.stepSigns.fill(B);let e=t-P,o=K;for(let n=0;n<v;++n){const r=t+n*v,c=r-P;this.keys.make(this.planeWords,e>>2,(n===0?c:c-v)>>2,c>>2,this.stepSigns,o),this.readSymbols(a,this.even,this.keys.even,0),this.keys.addSymbols(this.symbolWords),this.readSymbols(a,this.odd,this.keys.odd,1);const h=this.readRow(a,r,o);if(a.checkRead(),h)throw new p("bad_number");o=n+1<v&&s>>>n+1&1?_0:Aa,e=r}}readSymbols(a,t,s,e){const{symbols:o,slots:n,intervals:r}=this,{bytes:c,states:h}=a;t.look(s,r);let l=a.next,f=0,w=0,d=0,u=e;for(let y=0;y<E0;y=y+4|0)f=h[y],w=n[r[y]+(f&255)|0],f=Math.imul(w>>16,f>>8)+(f&255)-(w>>8&255)|0,d=f-256>>>31,h[y]=f<<(d<<3)|c[l]&-d,l=l+d|0,o[u]=w,f=h[y+1],w=n[r[y+1]+(f&255)|0],f=Math.imul(w>>16,f>>8)+(f&255)-(w>>8&255)|0,d=f-256>>>31,h[y+1]=f<<(d<<3)|c[l]&-d,l=l+d|0,o[u+2]=w,f=h[y+2],w=n[r[y+2]+(f&255)|0],f=Math.imul(w>>16,f>>8)+(f&255)-(w>>8&255)|0,d=f-256>>>31,h[y+2]=f<<(d<<3)|c[l]&-d,l=l+d|0,o[u+4]=w,f=h[y+3],w=n[r[y+3]+(f&255)|0],f=Math.imul(w>>16,f>>8)+(f&255)-(w>>8&255)|0,d=f-256>>>31,h[y+3]=f<<(d<<3)|c[l]&-d,l=l+d|0,o[u+6]=w,u=u+8|0;a.next=l}readRow(a,t,s){const{planeWords:e,symbolWords:o,stepSigns:n}=this,r=t-P>>2,c=s===K?r:t-v>>2,h=s===K?r:t-P-v>>2,l=t>>2;let f=0,w=67305985,d=Q;for(let u=0;u<J;u=u+1|0){const y=o[u];if((y&y>>1&B)!==0)return this.readRowWithOthers(a,t,s);const b=B+(y&B)-(y>>1&B);let g=b,x=B;s!==Aa&&(g=Math.imul(b,B)+f,f=Math.imul(g>>>24,B),x=w,w+=4*B);const T=e[r+u|0],A=e[c+u|0],E=(A|Q)-T,m=(A^e[h+u|0])+pa>>>7,I=E&Math.imul(E>>>7&m&B,127),_=(T+I|Q)+g-x;d&=_-T&(Q|538976288)-(_&pa)&_,e[l+u|0]=_&pa,n[u]=fa(g,x)}return d!==Q}readRowWithOthers(a,t,s){const{planes:e,symbols:o,stepSignBytes:n}=this,{bytes:r}=a,c=t-P,h=s===K?c:t-v,l=s===K?c:c-v;let f=0,w=!1;for(let d=0;d<v;++d){const u=o[d],y=u===3?r[a.next++]<<24>>24:u===2?-1:u;f=s===Aa?y:f+y;const b=e[c+d],g=e[h+d],x=(g===e[l+d]||g<b?b:g)+f;w||=x<b||x>v,e[t+d]=w?b:x,n[d]=f>0?2:f<0?0:1}return w}expand(a){const{ids:t,planeWords:s,firstOfHeight:e,nextOfHeight:o}=this;e.fill(-1);for(let n=t.length-1;n>0;--n){const r=n*J*v;for(let c=r;c<r+J*v;++c){const h=s[c];if(!(n+1<t.length&&h===s[c+J*v]))for(let l=0;l<4;++l){const f=h>>>8*l&255;o[4*c+l]=e[f],e[f]=4*c+l}}}a.fill(t[0],0,P);for(let n=0;n<v;++n){const r=n*P;n>0&&a.copyWithin(r,r-P,r);for(let c=e[n];c>=0;c=o[c])a[r+(c&P-1)]=t[c>>10]}}}function M0(i){const{bytes:a}=i,t=a[i.next++];let s=0;for(let e=0;e<4;++e)t>>e&1&&(s|=a[i.next++]<<8*e);if(i.checkRead(),t>15||(s&1)!==0)throw new p("bad_number");return s}function Wa(i){for(let a=1;a<i.length;++a)if(i[a]===i[a-1])throw new p("bad_materials")}function R0(i,a){const t=new Uint8Array(k);for(let o=0;o<k;++o){const n=i.states[o]-256;if(n>255)throw new p("bad_ending");t[o]=n}const s=[];let e=0;for(let o=0;o<a;++o){let n=0;for(let r=0;;r+=7){if(e===k||r>14)throw new p("bad_ending");const c=t[e++];if(n|=(c&127)<<r,!(c>=128)){if(c===0&&r>0||n>65535)throw new p("bad_ending");break}}s.push(n)}for(;e<k;++e)if(t[e]!==0)throw new p("bad_ending");return s}function o0(i,a,t,s){for(let n=0;n<t;++n)s[n]=i.read(a,n);let e=0,o=0;for(let n=0;n<t;++n){const r=s[n];if(r<2)continue;for(;e<r-1;)o|=i.bytes[i.next++]<<e,e+=8;const c=1<<r-1;s[n]=c|o&c-1,o>>>=r-1,e-=r-1}}const Fa=256;class i0{ids=new Uint16Array(Fa);slots=new Int32Array(256);take(a){const t=a.materials(Fa);for(let e=1;e<t.length;++e)if(t[e]===t[0]||e>1&&t[e]<=t[e-1])throw new p("bad_materials");if(a.left()<t.length)throw new p("truncated");const s=t.map((e,o)=>a.bytes[a.next+o]+1);ya(this.slots,s),this.ids.set(t),a.next+=t.length}read(a,t){return this.ids[a.read(this.slots,t)]}}const na=32768,xa=16;class q0{materials=new i0;digits=new Int32Array(256);lengths=new Int32Array(k);decode(a,t){this.materials.take(a);const s=a.number(),e=s===na;if(!e){if(a.left()<xa)throw new p("truncated");ya(this.digits,a.bytes.subarray(a.next,a.next+xa)),a.next+=xa}a.takeStates(),e?this.readSingle(a,t):this.readRuns(a,s,t),a.checkAllRead(),a.checkFinalStates()}readSingle(a,t){for(let s=0;s<na;++s)t[s]=this.materials.read(a,s%k),s%256===255&&a.checkRead()}readRuns(a,t,s){let e=0;for(let o=t;o>0;o-=k){const n=Math.min(o,k);o0(a,this.digits,n,this.lengths);let r=!1;for(let c=0;c<n;++c){const h=this.materials.read(a,c),l=e+this.lengths[c]+1;r||=l>na,!r&&(l===e+1?s[e]=h:s.fill(h,e,l),e=l)}if(a.checkRead(),r)throw new p("bad_number")}if(e!==na)throw new p("bad_number")}}const N0=[60,10,11,12,17,12,13,17,22,24,20,15,11,6,4,2],P0=`
53 85 199 28 163 242 50 180 206 83 153 208 43 218 236 91 198 217 110 180 237 122 229 245
134 210 236 151 250 253 151 173 218 21 46 248 8 20 28 15 28 42 18 254 255 44 85 240
53 95 131 22 71 83 49 252 253 59 241 245 21 254 255 162 203 234 100 123 252 81 237 247
35 251 252 62 135 230 122 141 251 115 135 252 59 246 252 199 211 231 8 251 253 105 140 250
69 251 255 116 249 252 166 220 221 75 254 255 130 178 201 146 233 239 164 223 244 158 240 249
189 234 238 183 236 248 188 209 247 189 252 253 200 235 247 209 247 250 206 253 254 216 235 245
223 253 254 222 245 246 229 249 252 232 254 255 240 254 255 241 248 249 228 233 234 245 254 255
240 244 250 249 250 251 250 254 255 252 254 255 253 254 255 132 182 228
`,L0=[`5555777d777ddfhk577d7bfebdbhfjjm57797dbh7bjefjjp7999bdhkb9hkenna
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
54NNaaaaaNaaaaaa2PdaaaaaaZaaaaaaPfPaaaaaa9aaaaaa6aahaaaaaaaaaaaa`],Ta=1<<30;class O0{gap=Ta;counts=new Int32Array(256);gaps=new Int32Array(k);ids=new Int32Array(k);materials;inGroup=0;taken=0;left=0;constructor(){ya(this.counts,N0)}begin(a,t,s){this.materials=t,this.left=s,this.readGroup(a)}take(a){const t=this.ids[this.taken++];return this.taken<this.inGroup?this.gap=this.gaps[this.taken]:this.readGroup(a),t}checkAllTaken(){if(this.gap<Ta-32768)throw new p("bad_number")}readGroup(a){const t=Math.min(this.left,k);if(this.taken=0,this.inGroup=t,this.left-=t,this.gap=Ta,t!==0){o0(a,this.counts,t,this.gaps);for(let s=0;s<t;++s)this.ids[s]=this.materials.read(a,s);this.gap=this.gaps[0]}}}const Ga=32;function B0(i,a,t,s,e,o,n,r){const c=n===Ga-1?n:n+1,h=n===0?0:n-1,l=i[t+n],f=i[s+n],w=i[e+n],d=i[o+n],u=f===w?l:f,y=f===w?f:l;let b=0,g=-1,x=-1;for(let T=n&1?0:2;T<10;++T){let A;switch(T){case 0:case 1:{const E=i[a+n-1],m=n===Ga-1?E:i[a+n+1];A=(u===m||u!==E&&y===m)===(T===0)?m:E;break}case 2:A=u;break;case 3:A=y;break;case 4:A=i[t+c];break;case 5:A=i[t+h];break;case 6:A=i[s+c];break;case 7:A=i[s+h];break;case 8:A=d;break;default:A=w}if(!(A===g||A===x)){if(b===r)return A;b===0?g=A:x=A,++b}}return-1}const U0=384;function j0(i){return i<=57?i-48:i<=90?i-65+10:i-97+36}function z0(){const i=P0.trim().split(/\s+/).map(Number);return L0.map(a=>{const t=a.replace(/\s/g,"");return Int32Array.from({length:U0},(s,e)=>{const o=3*j0(t.charCodeAt(e));return i[o]|i[o+1]<<8|i[o+2]<<16})})}const S=32,U=S*S,W0=94,oa=1431655765,F0=-1431655766,R=-1,ka=-1,O=16,va=O*(S/2);class G0{intervals=z0();materials=new i0;exceptions=new O0;buffer=new ArrayBuffer((U+1)*S*2);voxels=new Uint16Array(this.buffer);pairs=new Uint32Array(this.buffer);rowMaterial=new Int32Array(U+1);equalsWest=new Int32Array(U+1);equalsNorth=new Int32Array(U+1);equalsBelow=new Int32Array(U+1);north=new Int32Array(O);below=new Int32Array(O);belowNorth=new Int32Array(O);belowSouth=new Int32Array(O);same=new Int32Array(O);upright=new Int32Array(O);level=new Int32Array(O);levelSouth=new Int32Array(O);full=new Int32Array(O);quiet=new Uint8Array(O);contexts=new Int32Array(va);places=new Int32Array(va);escapes=new Int32Array(va);coded=0;decode(a,t){this.materials.take(a);const s=a.number();if(a.left()<1+2*k)throw new p("truncated");const e=this.intervals[a.bytes[a.next++]];if(e===void 0)throw new p("bad_number");a.takeStates(),this.begin(this.materials.ids[0]),this.exceptions.begin(a,this.materials,s);for(let o=0;o<W0;++o){const n=Math.max(0,o-S+2>>1),c=Math.min(S-1,o>>1)-n+1,h=n*S+o-2*n;this.coded=0;for(let l=0;l<c;++l)this.beginRow(a,l,h+30*l);this.readBatch(a,e),this.coded=0;for(let l=0;l<c;++l)this.finishRow(a,l,h+30*l);this.readBatch(a,e);for(let l=0;l<c;++l)this.compareRow(l,h+30*l)}this.exceptions.checkAllTaken(),a.checkAllRead(),a.checkFinalStates(),t.set(this.voxels.subarray(0,U*S))}begin(a){this.voxels.fill(a,U*S),this.rowMaterial[U]=a,this.equalsWest[U]=R}beginRow(a,t,s){const e=s&S-1;let o=s-1,n=s-S,r=n-1,c=n+1,h=R,l=R,f=R,w=R;s<S?(e===0&&(o=U),n=r=c=o):(e===0?o=r=n:(l=this.equalsBelow[o],f=this.equalsNorth[n],h=this.equalRows(o,n)),e===S-1?c=n:w=this.equalsNorth[c]);const d=this.equalsWest[o],u=this.equalsWest[n],y=d>>>1|2147483648,b=u>>>1|2147483648,g=h&l&w&d&y&u&b;this.north[t]=o,this.below[t]=n,this.belowNorth[t]=r,this.belowSouth[t]=c,this.same[t]=h,this.upright[t]=l,this.level[t]=f,this.levelSouth[t]=w,this.full[t]=g,this.copyBase(s,o,n,f);const{exceptions:x}=this,T=g===R?16:Ca(g&oa);if(x.gap>=T?(x.gap-=T,this.quiet[t]=g===R?1:0):(this.takeExceptions(a,s,g&oa,T),this.quiet[t]=0),g===R)return;const{voxels:A,contexts:E,places:m}=this;let I=this.coded;for(let _=~g&oa;_!==0;_&=_-1){const M=31-Math.clz32(_&-_),N=(d>>>M&1)<<2|(y>>>M&1)<<3|(u>>>M&1)<<4|(b>>>M&1)<<5,L=l>>>M&1,W=w>>>M&1,$=L|W<<1|N,X=64|f>>>M&1|L<<1|W<<2|C0(A[c*S+M]-A[o*S+M])<<3|(N&N<<1&8)<<1|N&N<<1&32;E[I]=X^(X^$)&-(h>>>M&1),m[I++]=t<<16|s*S+M}this.coded=I}finishRow(a,t,s){const{voxels:e,exceptions:o,contexts:n,places:r}=this;if(this.quiet[t]){o.gap>=16?o.gap-=16:(this.quiet[t]=0,this.takeExceptions(a,s,F0,16));return}const c=this.north[t]*S,h=this.below[t]*S,l=this.same[t],f=this.upright[t],w=this.level[t],d=this.levelSouth[t],u=this.full[t],y=this.equalsWest[this.north[t]],b=this.equalsWest[this.below[t]],g=s*S;let x=0,T=this.coded,A=e[g];for(let m=1;m<S;m+=2){const I=m===S-1?A:e[g+m+1],_=e[c+m];if(A===I){e[g+m]=A;const M=l>>>m&1;if(M&&_===A)u>>>m&1?x|=1<<m:(n[T]=128|f>>>m&1|(d>>>m&1)<<1|(y>>>m&1)<<2|(m===S-1?1:y>>>m+1&1)<<3|(b>>>m&1)<<4|(m===S-1?1:b>>>m+1&1)<<5,r[T++]=t<<16|g+m);else{const N=e[h+m],L=w>>>m&1,W=L?_:N,$=L?N:_;n[T]=192|(W===A?1:0)|($===A?2:0)|M<<2|(f>>>m&1)<<3|L<<4|(d>>>m&1)<<5,r[T++]=t<<16|g+m}}else{const M=e[h+m],N=w>>>m&1,L=N?_:M,W=N?M:_,$=L===I||L!==A&&W===I,X=$?I:A,La=$?A:I;e[g+m]=X,n[T]=256|(L===X?1:0)|(W===X?2:0)|(L===La?4:0)|(W===La?8:0)|(f>>>m&1)<<4|N<<5|(d>>>m&1)<<6,r[T++]=t<<16|g+m}A=I}this.coded=T;const E=Ca(x);o.gap>=E?o.gap-=E:this.takeExceptions(a,s,x,E)}takeExceptions(a,t,s,e){const{exceptions:o}=this;for(;o.gap<e;){for(let r=o.gap;r>0;--r)s&=s-1;const n=31-Math.clz32(s&-s);s&=s-1,e-=o.gap+1,this.voxels[t*S+n]=o.take(a)}o.gap-=e}readBatch(a,t){const{contexts:s,places:e,voxels:o,escapes:n,coded:r}=this,{bytes:c,states:h}=a;let l=a.next,f=0,w=!1;for(let d=0;d<r;++d){const u=t[s[d]],y=d&k-1;let b=h[y];const g=b&255,x=u&255;if(g<x)b=x*(b>>8)+g;else{const A=u>>8&255,E=u>>16,m=e[d];if(g>=E)b=(256-E)*(b>>8)+g-E,n[f++]=m&65535;else{let I=1;g<A?b=(A-x)*(b>>8)+g-x:(I=2,b=(E-A)*(b>>8)+g-A);const _=this.candidate(m,I);_<0?w=!0:o[m&65535]=_}}const T=b-256>>>31;h[y]=b<<(T<<3)|c[l]&-T,l+=T}a.next=l;for(let d=0;d<f;++d)o[n[d]]=this.materials.read(a,d&k-1);if(a.checkRead(),w)throw new p("bad_number")}candidate(a,t){const s=a>>>16,e=a&65535;return B0(this.voxels,e&-32,this.north[s]*S,this.below[s]*S,this.belowNorth[s]*S,this.belowSouth[s]*S,e&S-1,t)}copyBase(a,t,s,e){const{pairs:o,voxels:n}=this,r=a*(S/2),c=(e===R?t:s)*(S/2);for(let h=0;h<S/2;++h)o[r+h]=o[c+h];if(e!==R)for(let h=e&oa;h!==0;h&=h-1){const l=31-Math.clz32(h&-h);n[a*S+l]=n[t*S+l]}}compareRow(a,t){const s=this.north[a];if(this.quiet[a]){this.rowMaterial[t]=this.rowMaterial[s],this.equalsWest[t]=this.equalsNorth[t]=this.equalsBelow[t]=R;return}const{pairs:e}=this,o=this.below[a],n=t*(S/2),r=s*(S/2),c=o*(S/2);let h=e[n]<<16,l=0,f=0,w=0;for(let d=0;d<S/2;++d){const u=e[n+d]|0;l|=ia(u,u<<16|h>>>16)<<2*d,f|=ia(u,e[r+d])<<2*d,w|=ia(u,e[c+d])<<2*d,h=u}this.equalsWest[t]=l,this.equalsNorth[t]=f,this.equalsBelow[t]=w,this.rowMaterial[t]=l===R?h>>>16:ka}equalRows(a,t){const s=this.rowMaterial[a];if(s!==ka&&this.rowMaterial[t]!==ka)return s===this.rowMaterial[t]?R:0;const{pairs:e}=this,o=a*(S/2),n=t*(S/2);let r=0;for(let c=0;c<S/2;++c)r|=ia(e[o+c],e[n+c])<<2*c;return r}}function ia(i,a){const t=i^a;return(t&65535)-1>>>31|(t>>>16)-1>>>30&2}function C0(i){return(i|-i)>>>31^1}function Ca(i){return i-=i>>>1&1431655765,i=(i&858993459)+(i>>>2&858993459),Math.imul(i+(i>>>4)&252645135,16843009)>>>24}const $0=32768,r0=2*$0,j=16,Ea=16,$a=r0/64,ra=Uint8Array.from("b8fe6c3923a44bbe7c01812cf721ad1cded46de9839097db7240a4a4b7b3671fcb79e64eccc0e578825ad07dccff7221b8084674f743248ee03590e6813a264c3c2852bb91c300cb88d0658b1b532ea371644897a20df94e3819ef46a9deacd8a8fa763fe39c343ff9dcbbc7c70b4f1d8a51e04bcdb45931c89f7ec9d9787364eac5ac8334d3ebc3c581a0fffa1363eb170ddd51b7f0da49d316552629d4689e2b16be587d47a1fc8ff8b8d17ad031ce45cb3a8f95160428afd7fbcabb4b407e".match(/../g),i=>parseInt(i,16));function aa(i,a){return Int32Array.from({length:a},(t,s)=>{const e=i+4*s;return ra[e]|ra[e+1]<<8|ra[e+2]<<16|ra[e+3]<<24})}const X0=[3266489917,0,2246822535,2654435761,668265295,3266489917,2654435833,374761393,3266489955,2246822519,2246822519,0,374761413,668265263,2654435761,0],_a=-1640531535;class D0{words=new Int32Array(r0/4);voxels=new Uint16Array(this.words.buffer);sums=new Int32Array(16);stripeSecrets=aa(0,j+2*(Ea-1));lastSecret=aa(121,j);scrambleSecret=aa(128,j);lowSecret=aa(11,j);highSecret=aa(117,j);hash(){this.sums.set(X0);for(let s=0;s<$a-1;++s){const e=s%Ea;this.accumulate(s*j,this.stripeSecrets,2*e),e===Ea-1&&this.scramble()}this.accumulate(($a-1)*j,this.lastSecret,0);const a=this.merge(this.lowSecret,-897122304,2041677291);return this.merge(this.highSecret,347144191,1371723819)+a}accumulate(a,t,s){const{words:e,sums:o}=this;for(let n=0;n<j;n+=2){const r=e[a+n],c=e[a+n+1],h=r^t[s+n],l=c^t[s+n+1],f=Math.imul(h&65535,l>>>16),w=Math.imul(h>>>16,l&65535),d=(Math.imul(h&65535,l&65535)>>>16)+(f&65535)+(w&65535),u=Math.imul(h,l),y=Math.imul(h>>>16,l>>>16)+(f>>>16)+(w>>>16)+(d>>>16);let b=o[n]+u|0;o[n+1]=o[n+1]+y+(Ia(b,u)?1:0),o[n]=b;const g=n^2;b=o[g]+r|0,o[g+1]=o[g+1]+c+(Ia(b,r)?1:0),o[g]=b}}scramble(){const{sums:a,scrambleSecret:t}=this;for(let s=0;s<j;s+=2){const e=a[s+1],o=a[s]^e>>>15^t[s];a[s]=Math.imul(o,_a),a[s+1]=qa(o,_a)+Math.imul(e^t[s+1],_a)}}merge(a,t,s){const{sums:e}=this;let o=t|0,n=s|0;for(let c=0;c<j;c+=4){const[h,l,f,w]=V0(e[c]^a[c],e[c+1]^a[c+1],e[c+2]^a[c+2],e[c+3]^a[c+3]),d=h^f;o=o+d|0,n=n+(l^w)+(Ia(o,d)?1:0)|0}o^=n>>>5;const r=Math.imul(o,2654435833);return n=qa(o,-1640531463)+Math.imul(n,2654435833)+Math.imul(o,374761361)|0,o=r^n,Xa(n)+Xa(o)}}function Ia(i,a){return(i^2147483648)<(a^2147483648)}function qa(i,a){const t=Math.imul(i&65535,a>>>16),s=Math.imul(i>>>16,a&65535),e=(Math.imul(i&65535,a&65535)>>>16)+(t&65535)+(s&65535);return Math.imul(i>>>16,a>>>16)+(t>>>16)+(s>>>16)+(e>>>16)|0}function V0(i,a,t,s){const e=[[0,i,t],[1,i,s],[1,a,t],[2,a,s]],o=[0,0,0,0,0];for(const[n,r,c]of e)o[n]+=Math.imul(r,c)>>>0,o[n+1]+=qa(r,c)>>>0;for(let n=0;n<4;++n)o[n+1]+=Math.floor(o[n]/4294967296),o[n]=o[n]|0;return[o[0],o[1],o[2],o[3]]}function Xa(i){return(i>>>0).toString(16).padStart(8,"0")}let ca;function H0(i){return ca??=new D0,i.voxels===null?ca.voxels.fill(i.uniform):ca.voxels.set(i.voxels),ca.hash()}const wa=32768;class Y0{source=new y0;layers=new I0;volume=new G0;runs=new q0}let Da;function st(i,a={}){if(a.into!==void 0&&a.into.length!==wa)throw new z("out_of_range",`decodeChunk: into must have ${wa} voxels, not ${a.into.length}`);if(!ArrayBuffer.isView(i)||i.BYTES_PER_ELEMENT!==1)throw new z("out_of_range","decodeChunk: a payload is a Uint8Array");const t=Z0(i,a.into);if(a.hash!=null&&H0(t)!==a.hash)throw new p("bad_hash");return t}function Z0(i,a){if(i.length===0)throw new p("empty");const t=i[0];if(t!==3&&t!==4)throw new p("unknown_version");if(i.length<2)throw new p("truncated");if(i.length>Pa)throw new p("too_long");const s=i[1];if(t===3?s!==0:s===0||s>3)throw new p("unknown_encoding");Da??=new Y0;const{source:e,layers:o,volume:n,runs:r}=Da;e.begin(i);const c=t===3;if(c){const l=o.decode(e);if(l!==null)return{uniform:l,voxels:null}}const h=a??new Uint16Array(wa);return c?o.expand(h):s===2?K0(i,h):s===1?n.decode(e,h):r.decode(e,h),{uniform:null,voxels:h}}function K0(i,a){if(i.length<Pa)throw new p("truncated");for(let t=0;t<wa;++t)a[t]=i[2+2*t]|i[3+2*t]<<8}class J0 extends z{constructor(a,t,s,e,o){super(a,t,s),this.status=e,this.code=o}}const Va=3e4,Q0=16384;async function nt({fetch:i,token:a},t,s,e,o="GET"){const n=new AbortController,r=()=>n.abort();let c=!1,h;const l=()=>{clearTimeout(h),h=setTimeout(()=>{c=!0,r()},Va)};e.addEventListener("abort",r),e.aborted&&r(),l();try{const f=await i(t,{method:o,signal:n.signal,...a===void 0?{}:{headers:{Authorization:`Bearer ${a}`}}});if(!f.ok)throw await at(f,t);const w=f.headers.get("Talus-Revision");return{body:await c0(f,s,t,l),url:f.url,revision:w}}catch(f){if(f instanceof z)throw f;if(e.aborted)throw new z("cancelled",`the request for ${t} was given up`);if(c)throw new z("timed_out",`${t} did not answer within ${Va/1e3} s`);const w=f.cause?.message??f.message;throw new z("unreachable",`${t} cannot be reached: ${w}${l0(t)}`)}finally{e.removeEventListener("abort",r),clearTimeout(h),n.abort()}}async function c0(i,a,t,s=()=>{}){const e=i.body?.getReader();if(e===void 0)return new Uint8Array(0);let o=new Uint8Array(0),n=0;for(;;){const{done:r,value:c}=await e.read();if(s(),r)return o.subarray(0,n);if(n+c.length>a)throw e.cancel().catch(()=>{}),new z("broken_protocol",`${t} has more than ${a} bytes`);if(n===0)o=c;else{if(n+c.length>o.length){const h=new Uint8Array(Math.min(a,Math.max(2*o.length,n+c.length)));h.set(o.subarray(0,n)),o=h}o.set(c,n)}n+=c.length}}async function at(i,a){let t="",s=`${a.slice(0,200)} answered ${i.status}`,e=1e3*(Number(i.headers.get("Retry-After"))||0);try{const{error:o}=JSON.parse(new TextDecoder().decode(await c0(i,Q0,a)));t=String(o.code),s=`the server says: ${String(o.text)}`,e=Number(o.retry_after_ms)||e}catch{}return new J0(tt(i.status),s,e,i.status,t)}function tt(i){return i===401||i===403?"refused":i===429||i>=500?"overloaded":i===400?"out_of_range":"server_failed"}export{J0 as H,k as L,st as d,nt as g,H0 as h};
