import{T as _a}from"./uniform-dDORJD-b.js";const r0={empty:"has no bytes; it needs at least a version and an encoding",unknown_version:"begins with a byte that is no version known here, 3 or 4",unknown_encoding:"has a second byte that names no encoding of its version",truncated:"ends before the chunk does; it must be passed whole",too_long:"goes on after the chunk's end; it must be passed without other bytes",bad_materials:"has a list of materials that is empty, too long or out of order",bad_number:"holds a number that is past its range or not in its shortest form",bad_ending:"does not end as its chunk does; it was changed on its way",bad_hash:"decodes to voxels that do not have the hash it came with"};class x extends _a{constructor(a){super("bad_chunk",`the chunk payload ${r0[a]}`),this.fault=a}}const l0=32,ya=16,ma=l0/4,Za=0,Ya=2,Ha=4,U=6,$a=0,Ka=6,la=8,Ma=10,Ja=12,ha=14,V=16,Qa=18,a0=22,t0=24,aa=[$a,Ka,la,Ma,Ja,ha,V,Qa,a0,t0].reduce((i,a)=>i|3<<a,0),fa=2,da=4,e0=20,Y=26,Ra=28,Na=[[Qa,Ka],[Ra,Ma],[ha,la],[Ja,t0],[Y,$a],[a0,Ma],[ha,V],[la,V],[Ra,V],[ha,fa],[la,da],[V,fa],[V,da]],G=16843009,Oa=2139062143,Ba=-2139062144,ca=(i,a)=>{const t=(i|Ba)-a>>>7&G,e=(a|Ba)-i>>>7&G;return t+(e^G)},ta=1<<Za|1<<Ya,ja=3<<Ha,ea=3<<Y|3<<Ra;class h0{even=new Int32Array(ya);odd=new Int32Array(ya);make(a,t,e,s,o,n){const{even:r,odd:l}=this,c=n<<e0;let h=a[t],d=h<<24,w=0,f=0,u=0;for(let y=0;y<=ma;y=y+1|0){let b=ta|w>>>24&ja|ta<<8,S=0;if(y<ma){const A=y<ma-1?a[t+y+1|0]:Math.imul(h>>>24,G),T=a[e+y|0],p=ca(h,h<<8|d>>>24),v=ca(h>>>16|A<<16,h),m=h-T,_=(m+Oa>>>7&G)+(m+Oa-G>>>7&G);b=o[y]<<Za|p<<Ya|_<<Ha,S=v|ca(a[s+y|0],T)<<2,d=h,h=A}if(y===0)u=ta<<U|ta|b&ja,u=u<<U|b&255,u=u<<U|b>>>8&255;else{const A=(y<<1)-2;u=u<<U|w>>>16&255,r[A]=u&aa|f<<Y&ea|c,u=u<<U|w>>>24,l[A]=u&aa|f<<Y-8&ea|c,u=u<<U|b&255,r[A+1]=u&aa|f<<Y-16&ea|c,u=u<<U|b>>>8&255,l[A+1]=u&aa|f<<Y-24&ea|c}w=b,f=S}}addSymbols(a){const{odd:t}=this;let e=a[0];for(let s=0;s<ya;s=s+2|0){const o=a[(s>>1)+1];t[s]=t[s]|(e&3)<<fa|(e>>>16&3)<<da,t[s+1]=t[s+1]|(e>>>16&3)<<fa|(o&3)<<da,e=o}}}const k=16,ba=256,c0=2*k,Pa=65538,f0=4096;class d0{bytes=new Uint8Array(Pa+f0);states=new Int32Array(k);next=0;end=0;begin(a){this.bytes.set(a),this.next=2,this.end=a.length}left(){return this.end-this.next}number(){let a=0;for(let t=0;t<=14;t+=7){if(this.next>=this.end)throw new x("truncated");const e=this.bytes[this.next++];if(a|=(e&127)<<t,!(e>=128)){if(e===0&&t>0||a>65535)break;return a}}throw new x("bad_number")}materials(a){const t=this.number();if(t===0||t>a)throw new x("bad_materials");const e=[];for(let s=0;s<t;++s)e.push(this.number());return e}takeStates(){if(this.left()<c0)throw new x("truncated");for(let a=0;a<k;++a){const t=this.bytes[this.next]|this.bytes[this.next+1]<<8;if(t<ba)throw new x("bad_ending");this.states[a]=t,this.next+=2}}read(a,t){let e=this.states[t];const s=a[e&255];return e=(s>>>16)*(e>>8)+(e&255)-(s>>8&255),e<ba&&(e=e<<8|this.bytes[this.next++]),this.states[t]=e,s&255}checkRead(){if(this.next>this.end)throw new x("truncated")}checkAllRead(){if(this.next!==this.end)throw new x("too_long")}checkFinalStates(){for(let a=0;a<k;++a)if(this.states[a]!==ba)throw new x("bad_ending")}}function wa(i,a){let t=0;for(let e=0;e<a.length;++e){const s=a[e];if(t+s>256)throw new x("bad_number");i.fill(e|t<<8|s<<16,t,t+s),t+=s}if(t!==256)throw new x("bad_number")}const u0=[23,41,65,96,118,143,167,193,209,227,243,246,250,253,252,253],w0=[250,253,253,252,254,254,255,255,254,255,255,255,255,255,255,255],y0=[1,10,11,26,44,55,75,121,145,171,194,228,235,245,253,255],m0=[`41 52 53 40 54 68 55 40 53 54 47 40 40 40 40 40
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
0 0 0 0 1 0 0 0 0 0 0 0 0 0 0 0`],b0=Uint8Array.from(Na,([i])=>i),S0=Uint8Array.from(Na,([,i])=>i),g0=e0,p0=9,Z=16;function x0(i){const a=i.trim().split(/\s+/).map(Number);return Int32Array.from({length:a.length/2},(t,e)=>{const s=e>>4<<5|e&15;return a[s]<<16|a[s+16]&65535})}const s0=16,q=32-s0,F=(1<<q)-1,Sa=1<<31,H=-1640531535,za=16;class Wa{cache=new Int32Array(1<<s0).fill(Sa);weights;pairs;constructor(a){this.weights=m0.filter((t,e)=>e%2===1===a).map(x0),this.pairs=a?Na.length:p0}look(a,t){const{cache:e}=this;let s=0,o=0,n=0;for(let r=0;r<za;r=r+4|0)o=Math.imul(a[r],H),n=e[o>>>q],s|=n^o&F,t[r]=n>>>q<<8,o=Math.imul(a[r+1],H),n=e[o>>>q],s|=n^o&F,t[r+1]=n>>>q<<8,o=Math.imul(a[r+2],H),n=e[o>>>q],s|=n^o&F,t[r+2]=n>>>q<<8,o=Math.imul(a[r+3],H),n=e[o>>>q],s|=n^o&F,t[r+3]=n>>>q<<8;(s&(F|Sa))!==0&&this.fill(a,t)}fill(a,t){const{cache:e}=this;for(let s=0;s<za;++s){const o=Math.imul(a[s],H);let n=e[o>>>q];((n^o&F)&(F|Sa))!==0&&(n=this.classOf(a[s])<<q|o&F,e[o>>>q]=n),t[s]=n>>>q<<8}}classOf(a){const{pairs:t}=this,e=this.weights[a>>>g0&3];let s=0,o=0;for(let n=0;n<t;n=n+1|0){const r=e[n<<4|a>>>b0[n]&3|(a>>>S0[n]&3)<<2];s=Math.max(-128,Math.min(127,s+(r>>16)|0)),o=Math.max(-128,Math.min(127,o+(r<<16>>16)|0))}return(Math.max(s,0)>>3)*Z+(Math.max(o,0)>>3)}}function A0(){const i=new Int32Array(Z*Z<<8);for(let a=0;a<Z;++a){const t=u0[a],e=w0[a];for(let s=0;s<Z;++s){const o=t+1+((e-t-2)*y0[s]>>8),n=a*Z+s<<8;wa(i.subarray(n,n+256),[t,o-t,e-o,256-e])}}return i}const E=32,P=E*E,D=64,T0=k,ga=0,k0=1,$=2,K=E/4,B=16843009,pa=2139062143,J=-2139062144;class E0{even=new Wa(!1);odd=new Wa(!0);slots=A0();planes=new Uint8Array(P*D+E);planeWords=new Int32Array(this.planes.buffer);keys=new h0;intervals=new Int32Array(k);symbols=new Uint8Array(E+4);symbolWords=new Int32Array(this.symbols.buffer);stepSigns=new Int32Array(K);stepSignBytes=new Uint8Array(this.stepSigns.buffer);firstOfHeight=new Int32Array(E+1);nextOfHeight=new Int32Array(P*D);ids=[];decode(a){const t=a.next,e=a.number(),s=e>D+1&&e<=D+k;let o=[];if(!s&&(a.next=t,o=a.materials(D),Fa(o),o.length===1))return a.checkAllRead(),o[0];const n=(s?e-D:o.length)-1;a.takeStates();for(let r=1;r<=n;++r)this.readPlane(a,r*P);return a.checkAllRead(),s?(o=I0(a,n+1),Fa(o)):a.checkFinalStates(),this.ids=o,null}readPlane(a,t){const e=v0(a);this.stepSigns.fill(B);let s=t-P,o=$;for(let n=0;n<E;++n){const r=t+n*E,l=r-P;this.keys.make(this.planeWords,s>>2,(n===0?l:l-E)>>2,l>>2,this.stepSigns,o),this.readSymbols(a,this.even,this.keys.even,0),this.keys.addSymbols(this.symbolWords),this.readSymbols(a,this.odd,this.keys.odd,1);const c=this.readRow(a,r,o);if(a.checkRead(),c)throw new x("bad_number");o=n+1<E&&e>>>n+1&1?k0:ga,s=r}}readSymbols(a,t,e,s){const{symbols:o,slots:n,intervals:r}=this,{bytes:l,states:c}=a;t.look(e,r);let h=a.next,d=0,w=0,f=0,u=s;for(let y=0;y<T0;y=y+4|0)d=c[y],w=n[r[y]+(d&255)|0],d=Math.imul(w>>16,d>>8)+(d&255)-(w>>8&255)|0,f=d-256>>>31,c[y]=d<<(f<<3)|l[h]&-f,h=h+f|0,o[u]=w,d=c[y+1],w=n[r[y+1]+(d&255)|0],d=Math.imul(w>>16,d>>8)+(d&255)-(w>>8&255)|0,f=d-256>>>31,c[y+1]=d<<(f<<3)|l[h]&-f,h=h+f|0,o[u+2]=w,d=c[y+2],w=n[r[y+2]+(d&255)|0],d=Math.imul(w>>16,d>>8)+(d&255)-(w>>8&255)|0,f=d-256>>>31,c[y+2]=d<<(f<<3)|l[h]&-f,h=h+f|0,o[u+4]=w,d=c[y+3],w=n[r[y+3]+(d&255)|0],d=Math.imul(w>>16,d>>8)+(d&255)-(w>>8&255)|0,f=d-256>>>31,c[y+3]=d<<(f<<3)|l[h]&-f,h=h+f|0,o[u+6]=w,u=u+8|0;a.next=h}readRow(a,t,e){const{planeWords:s,symbolWords:o,stepSigns:n}=this,r=t-P>>2,l=e===$?r:t-E>>2,c=e===$?r:t-P-E>>2,h=t>>2;let d=0,w=67305985,f=J;for(let u=0;u<K;u=u+1|0){const y=o[u];if((y&y>>1&B)!==0)return this.readRowWithOthers(a,t,e);const b=B+(y&B)-(y>>1&B);let S=b,A=B;e!==ga&&(S=Math.imul(b,B)+d,d=Math.imul(S>>>24,B),A=w,w+=4*B);const T=s[r+u|0],p=s[l+u|0],v=(p|J)-T,m=(p^s[c+u|0])+pa>>>7,_=v&Math.imul(v>>>7&m&B,127),I=(T+_|J)+S-A;f&=I-T&(J|538976288)-(I&pa)&I,s[h+u|0]=I&pa,n[u]=ca(S,A)}return f!==J}readRowWithOthers(a,t,e){const{planes:s,symbols:o,stepSignBytes:n}=this,{bytes:r}=a,l=t-P,c=e===$?l:t-E,h=e===$?l:l-E;let d=0,w=!1;for(let f=0;f<E;++f){const u=o[f],y=u===3?r[a.next++]<<24>>24:u===2?-1:u;d=e===ga?y:d+y;const b=s[l+f],S=s[c+f],A=(S===s[h+f]||S<b?b:S)+d;w||=A<b||A>E,s[t+f]=w?b:A,n[f]=d>0?2:d<0?0:1}return w}expand(a){const{ids:t,planeWords:e,firstOfHeight:s,nextOfHeight:o}=this;s.fill(-1);for(let n=t.length-1;n>0;--n){const r=n*K*E;for(let l=r;l<r+K*E;++l){const c=e[l];if(!(n+1<t.length&&c===e[l+K*E]))for(let h=0;h<4;++h){const d=c>>>8*h&255;o[4*l+h]=s[d],s[d]=4*l+h}}}a.fill(t[0],0,P);for(let n=0;n<E;++n){const r=n*P;n>0&&a.copyWithin(r,r-P,r);for(let l=s[n];l>=0;l=o[l])a[r+(l&P-1)]=t[l>>10]}}}function v0(i){const{bytes:a}=i,t=a[i.next++];let e=0;for(let s=0;s<4;++s)t>>s&1&&(e|=a[i.next++]<<8*s);if(i.checkRead(),t>15||(e&1)!==0)throw new x("bad_number");return e}function Fa(i){for(let a=1;a<i.length;++a)if(i[a]===i[a-1])throw new x("bad_materials")}function I0(i,a){const t=new Uint8Array(k);for(let o=0;o<k;++o){const n=i.states[o]-256;if(n>255)throw new x("bad_ending");t[o]=n}const e=[];let s=0;for(let o=0;o<a;++o){let n=0;for(let r=0;;r+=7){if(s===k||r>14)throw new x("bad_ending");const l=t[s++];if(n|=(l&127)<<r,!(l>=128)){if(l===0&&r>0||n>65535)throw new x("bad_ending");break}}e.push(n)}for(;s<k;++s)if(t[s]!==0)throw new x("bad_ending");return e}function n0(i,a,t,e){for(let n=0;n<t;++n)e[n]=i.read(a,n);let s=0,o=0;for(let n=0;n<t;++n){const r=e[n];if(r<2)continue;for(;s<r-1;)o|=i.bytes[i.next++]<<s,s+=8;const l=1<<r-1;e[n]=l|o&l-1,o>>>=r-1,s-=r-1}}const Ua=256;class o0{ids=new Uint16Array(Ua);slots=new Int32Array(256);take(a){const t=a.materials(Ua);for(let s=1;s<t.length;++s)if(t[s]===t[0]||s>1&&t[s]<=t[s-1])throw new x("bad_materials");if(a.left()<t.length)throw new x("truncated");const e=t.map((s,o)=>a.bytes[a.next+o]+1);wa(this.slots,e),this.ids.set(t),a.next+=t.length}read(a,t){return this.ids[a.read(this.slots,t)]}}const sa=32768,xa=16;class _0{materials=new o0;digits=new Int32Array(256);lengths=new Int32Array(k);decode(a,t){this.materials.take(a);const e=a.number(),s=e===sa;if(!s){if(a.left()<xa)throw new x("truncated");wa(this.digits,a.bytes.subarray(a.next,a.next+xa)),a.next+=xa}a.takeStates(),s?this.readSingle(a,t):this.readRuns(a,e,t),a.checkAllRead(),a.checkFinalStates()}readSingle(a,t){for(let e=0;e<sa;++e)t[e]=this.materials.read(a,e%k),e%256===255&&a.checkRead()}readRuns(a,t,e){let s=0;for(let o=t;o>0;o-=k){const n=Math.min(o,k);n0(a,this.digits,n,this.lengths);let r=!1;for(let l=0;l<n;++l){const c=this.materials.read(a,l),h=s+this.lengths[l]+1;r||=h>sa,!r&&(h===s+1?e[s]=c:e.fill(c,s,h),s=h)}if(a.checkRead(),r)throw new x("bad_number")}if(s!==sa)throw new x("bad_number")}}const M0=[60,10,11,12,17,12,13,17,22,24,20,15,11,6,4,2],R0=`
53 85 199 28 163 242 50 180 206 83 153 208 43 218 236 91 198 217 110 180 237 122 229 245
134 210 236 151 250 253 151 173 218 21 46 248 8 20 28 15 28 42 18 254 255 44 85 240
53 95 131 22 71 83 49 252 253 59 241 245 21 254 255 162 203 234 100 123 252 81 237 247
35 251 252 62 135 230 122 141 251 115 135 252 59 246 252 199 211 231 8 251 253 105 140 250
69 251 255 116 249 252 166 220 221 75 254 255 130 178 201 146 233 239 164 223 244 158 240 249
189 234 238 183 236 248 188 209 247 189 252 253 200 235 247 209 247 250 206 253 254 216 235 245
223 253 254 222 245 246 229 249 252 232 254 255 240 254 255 241 248 249 228 233 234 245 254 255
240 244 250 249 250 251 250 254 255 252 254 255 253 254 255 132 182 228
`,q0=[`5555777d777ddfhk577d7bfebdbhfjjm57797dbh7bjefjjp7999bdhkb9hkenna
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
54NNaaaaaNaaaaaa2PdaaaaaaZaaaaaaPfPaaaaaa9aaaaaa6aahaaaaaaaaaaaa`],Aa=1<<30;class N0{gap=Aa;counts=new Int32Array(256);gaps=new Int32Array(k);ids=new Int32Array(k);materials;inGroup=0;taken=0;left=0;constructor(){wa(this.counts,M0)}begin(a,t,e){this.materials=t,this.left=e,this.readGroup(a)}take(a){const t=this.ids[this.taken++];return this.taken<this.inGroup?this.gap=this.gaps[this.taken]:this.readGroup(a),t}checkAllTaken(){if(this.gap<Aa-32768)throw new x("bad_number")}readGroup(a){const t=Math.min(this.left,k);if(this.taken=0,this.inGroup=t,this.left-=t,this.gap=Aa,t!==0){n0(a,this.counts,t,this.gaps);for(let e=0;e<t;++e)this.ids[e]=this.materials.read(a,e);this.gap=this.gaps[0]}}}const Ga=32;function P0(i,a,t,e,s,o,n,r){const l=n===Ga-1?n:n+1,c=n===0?0:n-1,h=i[t+n],d=i[e+n],w=i[s+n],f=i[o+n],u=d===w?h:d,y=d===w?d:h;let b=0,S=-1,A=-1;for(let T=n&1?0:2;T<10;++T){let p;switch(T){case 0:case 1:{const v=i[a+n-1],m=n===Ga-1?v:i[a+n+1];p=(u===m||u!==v&&y===m)===(T===0)?m:v;break}case 2:p=u;break;case 3:p=y;break;case 4:p=i[t+l];break;case 5:p=i[t+c];break;case 6:p=i[e+l];break;case 7:p=i[e+c];break;case 8:p=f;break;default:p=w}if(!(p===S||p===A)){if(b===r)return p;b===0?S=p:A=p,++b}}return-1}const L0=384;function O0(i){return i<=57?i-48:i<=90?i-65+10:i-97+36}function B0(){const i=R0.trim().split(/\s+/).map(Number);return q0.map(a=>{const t=a.replace(/\s/g,"");return Int32Array.from({length:L0},(e,s)=>{const o=3*O0(t.charCodeAt(s));return i[o]|i[o+1]<<8|i[o+2]<<16})})}const g=32,j=g*g,j0=94,na=1431655765,z0=-1431655766,R=-1,Ta=-1,O=16,ka=O*(g/2);class W0{intervals=B0();materials=new o0;exceptions=new N0;buffer=new ArrayBuffer((j+1)*g*2);voxels=new Uint16Array(this.buffer);pairs=new Uint32Array(this.buffer);rowMaterial=new Int32Array(j+1);equalsWest=new Int32Array(j+1);equalsNorth=new Int32Array(j+1);equalsBelow=new Int32Array(j+1);north=new Int32Array(O);below=new Int32Array(O);belowNorth=new Int32Array(O);belowSouth=new Int32Array(O);same=new Int32Array(O);upright=new Int32Array(O);level=new Int32Array(O);levelSouth=new Int32Array(O);full=new Int32Array(O);quiet=new Uint8Array(O);contexts=new Int32Array(ka);places=new Int32Array(ka);escapes=new Int32Array(ka);coded=0;decode(a,t){this.materials.take(a);const e=a.number();if(a.left()<1+2*k)throw new x("truncated");const s=this.intervals[a.bytes[a.next++]];if(s===void 0)throw new x("bad_number");a.takeStates(),this.begin(this.materials.ids[0]),this.exceptions.begin(a,this.materials,e);for(let o=0;o<j0;++o){const n=Math.max(0,o-g+2>>1),l=Math.min(g-1,o>>1)-n+1,c=n*g+o-2*n;this.coded=0;for(let h=0;h<l;++h)this.beginRow(a,h,c+30*h);this.readBatch(a,s),this.coded=0;for(let h=0;h<l;++h)this.finishRow(a,h,c+30*h);this.readBatch(a,s);for(let h=0;h<l;++h)this.compareRow(h,c+30*h)}this.exceptions.checkAllTaken(),a.checkAllRead(),a.checkFinalStates(),t.set(this.voxels.subarray(0,j*g))}begin(a){this.voxels.fill(a,j*g),this.rowMaterial[j]=a,this.equalsWest[j]=R}beginRow(a,t,e){const s=e&g-1;let o=e-1,n=e-g,r=n-1,l=n+1,c=R,h=R,d=R,w=R;e<g?(s===0&&(o=j),n=r=l=o):(s===0?o=r=n:(h=this.equalsBelow[o],d=this.equalsNorth[n],c=this.equalRows(o,n)),s===g-1?l=n:w=this.equalsNorth[l]);const f=this.equalsWest[o],u=this.equalsWest[n],y=f>>>1|2147483648,b=u>>>1|2147483648,S=c&h&w&f&y&u&b;this.north[t]=o,this.below[t]=n,this.belowNorth[t]=r,this.belowSouth[t]=l,this.same[t]=c,this.upright[t]=h,this.level[t]=d,this.levelSouth[t]=w,this.full[t]=S,this.copyBase(e,o,n,d);const{exceptions:A}=this,T=S===R?16:Ca(S&na);if(A.gap>=T?(A.gap-=T,this.quiet[t]=S===R?1:0):(this.takeExceptions(a,e,S&na,T),this.quiet[t]=0),S===R)return;const{voxels:p,contexts:v,places:m}=this;let _=this.coded;for(let I=~S&na;I!==0;I&=I-1){const M=31-Math.clz32(I&-I),N=(f>>>M&1)<<2|(y>>>M&1)<<3|(u>>>M&1)<<4|(b>>>M&1)<<5,L=h>>>M&1,W=w>>>M&1,C=L|W<<1|N,X=64|d>>>M&1|L<<1|W<<2|F0(p[l*g+M]-p[o*g+M])<<3|(N&N<<1&8)<<1|N&N<<1&32;v[_]=X^(X^C)&-(c>>>M&1),m[_++]=t<<16|e*g+M}this.coded=_}finishRow(a,t,e){const{voxels:s,exceptions:o,contexts:n,places:r}=this;if(this.quiet[t]){o.gap>=16?o.gap-=16:(this.quiet[t]=0,this.takeExceptions(a,e,z0,16));return}const l=this.north[t]*g,c=this.below[t]*g,h=this.same[t],d=this.upright[t],w=this.level[t],f=this.levelSouth[t],u=this.full[t],y=this.equalsWest[this.north[t]],b=this.equalsWest[this.below[t]],S=e*g;let A=0,T=this.coded,p=s[S];for(let m=1;m<g;m+=2){const _=m===g-1?p:s[S+m+1],I=s[l+m];if(p===_){s[S+m]=p;const M=h>>>m&1;if(M&&I===p)u>>>m&1?A|=1<<m:(n[T]=128|d>>>m&1|(f>>>m&1)<<1|(y>>>m&1)<<2|(m===g-1?1:y>>>m+1&1)<<3|(b>>>m&1)<<4|(m===g-1?1:b>>>m+1&1)<<5,r[T++]=t<<16|S+m);else{const N=s[c+m],L=w>>>m&1,W=L?I:N,C=L?N:I;n[T]=192|(W===p?1:0)|(C===p?2:0)|M<<2|(d>>>m&1)<<3|L<<4|(f>>>m&1)<<5,r[T++]=t<<16|S+m}}else{const M=s[c+m],N=w>>>m&1,L=N?I:M,W=N?M:I,C=L===_||L!==p&&W===_,X=C?_:p,La=C?p:_;s[S+m]=X,n[T]=256|(L===X?1:0)|(W===X?2:0)|(L===La?4:0)|(W===La?8:0)|(d>>>m&1)<<4|N<<5|(f>>>m&1)<<6,r[T++]=t<<16|S+m}p=_}this.coded=T;const v=Ca(A);o.gap>=v?o.gap-=v:this.takeExceptions(a,e,A,v)}takeExceptions(a,t,e,s){const{exceptions:o}=this;for(;o.gap<s;){for(let r=o.gap;r>0;--r)e&=e-1;const n=31-Math.clz32(e&-e);e&=e-1,s-=o.gap+1,this.voxels[t*g+n]=o.take(a)}o.gap-=s}readBatch(a,t){const{contexts:e,places:s,voxels:o,escapes:n,coded:r}=this,{bytes:l,states:c}=a;let h=a.next,d=0,w=!1;for(let f=0;f<r;++f){const u=t[e[f]],y=f&k-1;let b=c[y];const S=b&255,A=u&255;if(S<A)b=A*(b>>8)+S;else{const p=u>>8&255,v=u>>16,m=s[f];if(S>=v)b=(256-v)*(b>>8)+S-v,n[d++]=m&65535;else{let _=1;S<p?b=(p-A)*(b>>8)+S-A:(_=2,b=(v-p)*(b>>8)+S-p);const I=this.candidate(m,_);I<0?w=!0:o[m&65535]=I}}const T=b-256>>>31;c[y]=b<<(T<<3)|l[h]&-T,h+=T}a.next=h;for(let f=0;f<d;++f)o[n[f]]=this.materials.read(a,f&k-1);if(a.checkRead(),w)throw new x("bad_number")}candidate(a,t){const e=a>>>16,s=a&65535;return P0(this.voxels,s&-32,this.north[e]*g,this.below[e]*g,this.belowNorth[e]*g,this.belowSouth[e]*g,s&g-1,t)}copyBase(a,t,e,s){const{pairs:o,voxels:n}=this,r=a*(g/2),l=(s===R?t:e)*(g/2);for(let c=0;c<g/2;++c)o[r+c]=o[l+c];if(s!==R)for(let c=s&na;c!==0;c&=c-1){const h=31-Math.clz32(c&-c);n[a*g+h]=n[t*g+h]}}compareRow(a,t){const e=this.north[a];if(this.quiet[a]){this.rowMaterial[t]=this.rowMaterial[e],this.equalsWest[t]=this.equalsNorth[t]=this.equalsBelow[t]=R;return}const{pairs:s}=this,o=this.below[a],n=t*(g/2),r=e*(g/2),l=o*(g/2);let c=s[n]<<16,h=0,d=0,w=0;for(let f=0;f<g/2;++f){const u=s[n+f]|0;h|=oa(u,u<<16|c>>>16)<<2*f,d|=oa(u,s[r+f])<<2*f,w|=oa(u,s[l+f])<<2*f,c=u}this.equalsWest[t]=h,this.equalsNorth[t]=d,this.equalsBelow[t]=w,this.rowMaterial[t]=h===R?c>>>16:Ta}equalRows(a,t){const e=this.rowMaterial[a];if(e!==Ta&&this.rowMaterial[t]!==Ta)return e===this.rowMaterial[t]?R:0;const{pairs:s}=this,o=a*(g/2),n=t*(g/2);let r=0;for(let l=0;l<g/2;++l)r|=oa(s[o+l],s[n+l])<<2*l;return r}}function oa(i,a){const t=i^a;return(t&65535)-1>>>31|(t>>>16)-1>>>30&2}function F0(i){return(i|-i)>>>31^1}function Ca(i){return i-=i>>>1&1431655765,i=(i&858993459)+(i>>>2&858993459),Math.imul(i+(i>>>4)&252645135,16843009)>>>24}const U0=32768,i0=2*U0,z=16,Ea=16,Xa=i0/64,ia=Uint8Array.from("b8fe6c3923a44bbe7c01812cf721ad1cded46de9839097db7240a4a4b7b3671fcb79e64eccc0e578825ad07dccff7221b8084674f743248ee03590e6813a264c3c2852bb91c300cb88d0658b1b532ea371644897a20df94e3819ef46a9deacd8a8fa763fe39c343ff9dcbbc7c70b4f1d8a51e04bcdb45931c89f7ec9d9787364eac5ac8334d3ebc3c581a0fffa1363eb170ddd51b7f0da49d316552629d4689e2b16be587d47a1fc8ff8b8d17ad031ce45cb3a8f95160428afd7fbcabb4b407e".match(/../g),i=>parseInt(i,16));function Q(i,a){return Int32Array.from({length:a},(t,e)=>{const s=i+4*e;return ia[s]|ia[s+1]<<8|ia[s+2]<<16|ia[s+3]<<24})}const G0=[3266489917,0,2246822535,2654435761,668265295,3266489917,2654435833,374761393,3266489955,2246822519,2246822519,0,374761413,668265263,2654435761,0],va=-1640531535;class C0{words=new Int32Array(i0/4);voxels=new Uint16Array(this.words.buffer);sums=new Int32Array(16);stripeSecrets=Q(0,z+2*(Ea-1));lastSecret=Q(121,z);scrambleSecret=Q(128,z);lowSecret=Q(11,z);highSecret=Q(117,z);hash(){this.sums.set(G0);for(let e=0;e<Xa-1;++e){const s=e%Ea;this.accumulate(e*z,this.stripeSecrets,2*s),s===Ea-1&&this.scramble()}this.accumulate((Xa-1)*z,this.lastSecret,0);const a=this.merge(this.lowSecret,-897122304,2041677291);return this.merge(this.highSecret,347144191,1371723819)+a}accumulate(a,t,e){const{words:s,sums:o}=this;for(let n=0;n<z;n+=2){const r=s[a+n],l=s[a+n+1],c=r^t[e+n],h=l^t[e+n+1],d=Math.imul(c&65535,h>>>16),w=Math.imul(c>>>16,h&65535),f=(Math.imul(c&65535,h&65535)>>>16)+(d&65535)+(w&65535),u=Math.imul(c,h),y=Math.imul(c>>>16,h>>>16)+(d>>>16)+(w>>>16)+(f>>>16);let b=o[n]+u|0;o[n+1]=o[n+1]+y+(Ia(b,u)?1:0),o[n]=b;const S=n^2;b=o[S]+r|0,o[S+1]=o[S+1]+l+(Ia(b,r)?1:0),o[S]=b}}scramble(){const{sums:a,scrambleSecret:t}=this;for(let e=0;e<z;e+=2){const s=a[e+1],o=a[e]^s>>>15^t[e];a[e]=Math.imul(o,va),a[e+1]=qa(o,va)+Math.imul(s^t[e+1],va)}}merge(a,t,e){const{sums:s}=this;let o=t|0,n=e|0;for(let l=0;l<z;l+=4){const[c,h,d,w]=X0(s[l]^a[l],s[l+1]^a[l+1],s[l+2]^a[l+2],s[l+3]^a[l+3]),f=c^d;o=o+f|0,n=n+(h^w)+(Ia(o,f)?1:0)|0}o^=n>>>5;const r=Math.imul(o,2654435833);return n=qa(o,-1640531463)+Math.imul(n,2654435833)+Math.imul(o,374761361)|0,o=r^n,Da(n)+Da(o)}}function Ia(i,a){return(i^2147483648)<(a^2147483648)}function qa(i,a){const t=Math.imul(i&65535,a>>>16),e=Math.imul(i>>>16,a&65535),s=(Math.imul(i&65535,a&65535)>>>16)+(t&65535)+(e&65535);return Math.imul(i>>>16,a>>>16)+(t>>>16)+(e>>>16)+(s>>>16)|0}function X0(i,a,t,e){const s=[[0,i,t],[1,i,e],[1,a,t],[2,a,e]],o=[0,0,0,0,0];for(const[n,r,l]of s)o[n]+=Math.imul(r,l)>>>0,o[n+1]+=qa(r,l)>>>0;for(let n=0;n<4;++n)o[n+1]+=Math.floor(o[n]/4294967296),o[n]=o[n]|0;return[o[0],o[1],o[2],o[3]]}function Da(i){return(i>>>0).toString(16).padStart(8,"0")}let ra;function D0(i){return ra??=new C0,i.voxels===null?ra.voxels.fill(i.uniform):ra.voxels.set(i.voxels),ra.hash()}const ua=32768;class V0{source=new d0;layers=new E0;volume=new W0;runs=new _0}let Va;function $0(i,a={}){if(a.into!==void 0&&a.into.length!==ua)throw new _a("out_of_range",`decodeChunk: into must have ${ua} voxels, not ${a.into.length}`);if(!ArrayBuffer.isView(i)||i.BYTES_PER_ELEMENT!==1)throw new _a("out_of_range","decodeChunk: a payload is a Uint8Array");const t=Z0(i,a.into);if(a.hash!=null&&D0(t)!==a.hash)throw new x("bad_hash");return t}function Z0(i,a){if(i.length===0)throw new x("empty");const t=i[0];if(t!==3&&t!==4)throw new x("unknown_version");if(i.length<2)throw new x("truncated");if(i.length>Pa)throw new x("too_long");const e=i[1];if(t===3?e!==0:e===0||e>3)throw new x("unknown_encoding");Va??=new V0;const{source:s,layers:o,volume:n,runs:r}=Va;s.begin(i);const l=t===3;if(l){const h=o.decode(s);if(h!==null)return{uniform:h,voxels:null}}const c=a??new Uint16Array(ua);return l?o.expand(c):e===2?Y0(i,c):e===1?n.decode(s,c):r.decode(s,c),{uniform:null,voxels:c}}function Y0(i,a){if(i.length<Pa)throw new x("truncated");for(let t=0;t<ua;++t)a[t]=i[2+2*t]|i[3+2*t]<<8}export{k as L,$0 as d,D0 as h};
