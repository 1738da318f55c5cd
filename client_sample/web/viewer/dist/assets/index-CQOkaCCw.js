const __vite__mapDeps=(i,m=__vite__mapDeps,d=(m.f||(m.f=["./overlay-B4opBDkl.js","./screen-DwvEnKDz.js","./token_dialog-UEjuTb4-.js","./token_dialog-Dwos6vDS.css"])))=>i.map(i=>d[i]);
import{f as mt,m as An,s as re,w as _h,c as Xp,a as xh,b as qp,T as $p,S as Yp,r as Sc,d as Kp,e as Zp,g as Jp,h as Qp,i as jp}from"./token_dialog-UEjuTb4-.js";const tm=(function(){const t=typeof document<"u"&&document.createElement("link").relList;return t&&t.supports&&t.supports("modulepreload")?"modulepreload":"preload"})(),em=function(i,t){return new URL(i,t).href},wh={},nm=function(t,e,n){let s=Promise.resolve();if(e&&e.length>0){let a=function(h){return Promise.all(h.map(u=>Promise.resolve(u).then(d=>({status:"fulfilled",value:d}),d=>({status:"rejected",reason:d}))))};const o=document.getElementsByTagName("link"),l=document.querySelector("meta[property=csp-nonce]"),c=l?.nonce||l?.getAttribute("nonce");s=a(e.map(h=>{if(h=em(h,n),h in wh)return;wh[h]=!0;const u=h.endsWith(".css"),d=u?'[rel="stylesheet"]':"";if(!!n)for(let x=o.length-1;x>=0;x--){const g=o[x];if(g.href===h&&(!u||g.rel==="stylesheet"))return}else if(document.querySelector(`link[href="${h}"]${d}`))return;const m=document.createElement("link");if(m.rel=u?"stylesheet":tm,u||(m.as="script"),m.crossOrigin="",m.href=h,c&&m.setAttribute("nonce",c),document.head.appendChild(m),u)return new Promise((x,g)=>{m.addEventListener("load",x),m.addEventListener("error",()=>g(new Error(`Unable to preload CSS for ${h}`)))})}))}function r(a){const o=new Event("vite:preloadError",{cancelable:!0});if(o.payload=a,window.dispatchEvent(o),!o.defaultPrevented)throw a}return s.then(a=>{for(const o of a||[])o.status==="rejected"&&r(o.reason);return t().catch(r)})},Sh=new Set;function im(i,t){const e=[["talus:first",i.firstFrameMs],["talus:complete",i.completeMs]];for(const[n,s]of e)s===null||Sh.has(n)||(Sh.add(n),performance.mark(n,{startTime:t+s}))}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const Mc="187",sm=0,Mh=1,rm=2,ea=1,am=2,Gs=3,mi=0,Ve=1,Ln=2,os=0,qs=1,yh=2,Eh=3,bh=4,om=5,es=100,lm=101,cm=102,hm=103,um=104,dm=200,fm=201,pm=202,mm=203,Gd=204,Hd=205,gm=206,vm=207,_m=208,xm=209,wm=210,Sm=211,Mm=212,ym=213,Em=214,sl=0,rl=1,al=2,js=3,ol=4,ll=5,cl=6,hl=7,Vd=0,bm=1,Tm=2,Qn=0,Wd=1,Xd=2,qd=3,$d=4,Yd=5,Kd=6,Zd=7,Jd=300,hs=301,tr=302,Qa=303,ja=304,va=1e3,Jn=1001,ul=1002,xe=1003,Am=1004,hr=1005,Fe=1006,to=1007,ui=1008,sn=1009,Qd=1010,jd=1011,er=1012,yc=1013,ln=1014,rn=1015,xn=1016,Ec=1017,bc=1018,us=1020,tf=35902,ef=35899,nf=1021,sf=1022,an=1023,gi=1026,di=1027,rf=1028,Tc=1029,vi=1030,za=1031,Ac=1033,na=33776,ia=33777,sa=33778,ra=33779,dl=35840,fl=35841,pl=35842,ml=35843,gl=36196,vl=37492,_l=37496,xl=37488,wl=37489,_a=37490,Sl=37491,Ml=37808,yl=37809,El=37810,bl=37811,Tl=37812,Al=37813,Rl=37814,Cl=37815,Ll=37816,Pl=37817,Il=37818,Dl=37819,Nl=37820,Ul=37821,Fl=36492,Ol=36494,kl=36495,Bl=36283,zl=36284,xa=36285,Gl=36286,Rm=3200,Th=0,Cm=1,qn="",nn="srgb",wa="srgb-linear",Sa="linear",ne="srgb",eo=7680,Lm=519,Pm=512,Im=513,Dm=514,Rc=515,Nm=516,Um=517,af=518,of=519,Fm=35044,Li="300 es",gn=2e3,Ma=2001;function Om(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function ya(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function km(){const i=ya("canvas");return i.style.display="block",i}const Ah={};function Rh(...i){const t="THREE."+i.shift();console.log(t,...i)}function lf(i){const t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){const e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Pt(...i){i=lf(i);const t="THREE."+i.shift();{const e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function Jt(...i){i=lf(i);const t="THREE."+i.shift();{const e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function aa(...i){const t=i.join(" ");t in Ah||(Ah[t]=!0,Pt(...i))}function Bm(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}const zm={[sl]:sl,[al]:cl,[ol]:ol,[js]:ll,[rl]:rl,[cl]:al,[hl]:hl,[ll]:js};class Gi{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});const n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){const n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){const n=this._listeners;if(n===void 0)return;const s=n[t];if(s!==void 0){const r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){const e=this._listeners;if(e===void 0)return;const n=e[t.type];if(n!==void 0){t.target=this;const s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,t);t.target=null}}}const Ne=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],no=Math.PI/180,Hl=180/Math.PI;function ir(){const i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Ne[i&255]+Ne[i>>8&255]+Ne[i>>16&255]+Ne[i>>24&255]+"-"+Ne[t&255]+Ne[t>>8&255]+"-"+Ne[t>>16&15|64]+Ne[t>>24&255]+"-"+Ne[e&63|128]+Ne[e>>8&255]+"-"+Ne[e>>16&255]+Ne[e>>24&255]+Ne[n&255]+Ne[n>>8&255]+Ne[n>>16&255]+Ne[n>>24&255]).toLowerCase()}function Xt(i,t,e){return Math.max(t,Math.min(e,i))}function Gm(i,t){return(i%t+t)%t}function io(i,t,e){return(1-e)*i+e*t}function Hm(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Cc(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Vm(i,t){if(t.constructor===Float32Array)return i;const e=Cc(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Wm(i,t){if(t.constructor===Float32Array)return i;const e=Cc(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}class Kt{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){const e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Xt(this.x,t.x,e.x),this.y=Xt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Xt(this.x,t,e),this.y=Xt(this.y,t,e),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Xt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(Xt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){const n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,a=this.y-t.y;return this.x=r*n-a*s+t.x,this.y=r*s+a*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class gs{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,a,o){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[a+0],f=r[a+1],m=r[a+2],x=r[a+3];if(u!==x||l!==d||c!==f||h!==m){let g=l*d+c*f+h*m+u*x;g<0&&(d=-d,f=-f,m=-m,x=-x,g=-g);let p=1-o;if(g<.9995){const S=Math.acos(g),T=Math.sin(S);p=Math.sin(p*S)/T,o=Math.sin(o*S)/T,l=l*p+d*o,c=c*p+f*o,h=h*p+m*o,u=u*p+x*o}else{l=l*p+d*o,c=c*p+f*o,h=h*p+m*o,u=u*p+x*o;const S=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=S,c*=S,h*=S,u*=S}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,a){const o=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[a],d=r[a+1],f=r[a+2],m=r[a+3];return t[e]=o*m+h*u+l*f-c*d,t[e+1]=l*m+h*d+c*u-o*f,t[e+2]=c*m+h*f+o*d-l*u,t[e+3]=h*m-o*u-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){const n=t._x,s=t._y,r=t._z,a=t._order,o=Math.cos,l=Math.sin,c=o(n/2),h=o(s/2),u=o(r/2),d=l(n/2),f=l(s/2),m=l(r/2);switch(a){case"XYZ":this._x=d*h*u+c*f*m,this._y=c*f*u-d*h*m,this._z=c*h*m+d*f*u,this._w=c*h*u-d*f*m;break;case"YXZ":this._x=d*h*u+c*f*m,this._y=c*f*u-d*h*m,this._z=c*h*m-d*f*u,this._w=c*h*u+d*f*m;break;case"ZXY":this._x=d*h*u-c*f*m,this._y=c*f*u+d*h*m,this._z=c*h*m+d*f*u,this._w=c*h*u-d*f*m;break;case"ZYX":this._x=d*h*u-c*f*m,this._y=c*f*u+d*h*m,this._z=c*h*m-d*f*u,this._w=c*h*u+d*f*m;break;case"YZX":this._x=d*h*u+c*f*m,this._y=c*f*u+d*h*m,this._z=c*h*m-d*f*u,this._w=c*h*u-d*f*m;break;case"XZY":this._x=d*h*u-c*f*m,this._y=c*f*u-d*h*m,this._z=c*h*m+d*f*u,this._w=c*h*u+d*f*m;break;default:Pt("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){const n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){const e=t.elements,n=e[0],s=e[4],r=e[8],a=e[1],o=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=n+o+u;if(d>0){const f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(a-s)*f}else if(n>o&&n>u){const f=2*Math.sqrt(1+n-o-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+a)/f,this._z=(r+c)/f}else if(o>u){const f=2*Math.sqrt(1+o-n-u);this._w=(r-c)/f,this._x=(s+a)/f,this._y=.25*f,this._z=(l+h)/f}else{const f=2*Math.sqrt(1+u-n-o);this._w=(a-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Xt(this.dot(t),-1,1)))}rotateTowards(t,e){const n=this.angleTo(t);if(n===0)return this;const s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){const n=t._x,s=t._y,r=t._z,a=t._w,o=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+a*o+s*c-r*l,this._y=s*h+a*l+r*o-n*c,this._z=r*h+a*c+n*l-s*o,this._w=a*h-n*o-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,a=t._w,o=this.dot(t);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let l=1-e;if(o<.9995){const c=Math.acos(o),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+a*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+a*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){const t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class F{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Ch.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Ch.setFromAxisAngle(t,e))}applyMatrix3(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=t.elements,a=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(t){const e=this.x,n=this.y,s=this.z,r=t.x,a=t.y,o=t.z,l=t.w,c=2*(a*s-o*n),h=2*(o*e-r*s),u=2*(r*n-a*e);return this.x=e+l*c+a*u-o*h,this.y=n+l*h+o*c-r*u,this.z=s+l*u+r*h-a*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Xt(this.x,t.x,e.x),this.y=Xt(this.y,t.y,e.y),this.z=Xt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Xt(this.x,t,e),this.y=Xt(this.y,t,e),this.z=Xt(this.z,t,e),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Xt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){const n=t.x,s=t.y,r=t.z,a=e.x,o=e.y,l=e.z;return this.x=s*l-r*o,this.y=r*a-n*l,this.z=n*o-s*a,this}projectOnVector(t){const e=t.lengthSq();if(e===0)return this.set(0,0,0);const n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return so.copy(this).projectOnVector(t),this.sub(so)}reflect(t){return this.sub(so.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(Xt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){const s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){const e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const so=new F,Ch=new gs;class Dt{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,l,c)}set(t,e,n,s,r,a,o,l,c){const h=this.elements;return h[0]=t,h[1]=s,h[2]=o,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){const e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],m=n[8],x=s[0],g=s[3],p=s[6],S=s[1],T=s[4],M=s[7],A=s[2],E=s[5],v=s[8];return r[0]=a*x+o*S+l*A,r[3]=a*g+o*T+l*E,r[6]=a*p+o*M+l*v,r[1]=c*x+h*S+u*A,r[4]=c*g+h*T+u*E,r[7]=c*p+h*M+u*v,r[2]=d*x+f*S+m*A,r[5]=d*g+f*T+m*E,r[8]=d*p+f*M+m*v,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8];return e*a*h-e*o*c-n*r*h+n*o*l+s*r*c-s*a*l}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8],u=h*a-o*c,d=o*l-h*r,f=c*r-a*l,m=e*u+n*d+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);const x=1/m;return t[0]=u*x,t[1]=(s*c-h*n)*x,t[2]=(o*n-s*a)*x,t[3]=d*x,t[4]=(h*e-s*l)*x,t[5]=(s*r-o*e)*x,t[6]=f*x,t[7]=(n*l-c*e)*x,t[8]=(a*e-n*r)*x,this}transpose(){let t;const e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){const e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,a,o){const l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*a+c*o)+a+t,-s*c,s*l,-s*(-c*a+l*o)+o+e,0,0,1),this}scale(t,e){return aa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ro.makeScale(t,e)),this}rotate(t){return aa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ro.makeRotation(-t)),this}translate(t,e){return aa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ro.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}}const ro=new Dt,Lh=new Dt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Ph=new Dt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Xm(){const i={enabled:!0,workingColorSpace:wa,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===ne&&(s.r=jn(s.r),s.g=jn(s.g),s.b=jn(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===ne&&(s.r=ls(s.r),s.g=ls(s.g),s.b=ls(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===qn?Sa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[wa]:{primaries:t,whitePoint:n,transfer:Sa,toXYZ:Lh,fromXYZ:Ph,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:nn},outputColorSpaceConfig:{drawingBufferColorSpace:nn}},[nn]:{primaries:t,whitePoint:n,transfer:ne,toXYZ:Lh,fromXYZ:Ph,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:nn}}}),i}const qt=Xm();function jn(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function ls(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}let Hi;class qm{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Hi===void 0&&(Hi=ya("canvas")),Hi.width=t.width,Hi.height=t.height;const s=Hi.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Hi}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){const e=ya("canvas");e.width=t.width,e.height=t.height;const n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);const s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=jn(r[a]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){const e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(jn(e[n]/255)*255):e[n]=jn(e[n]);return{data:e,width:t.width,height:t.height}}else return Pt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}}let $m=0;class Lc{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:$m++}),this.uuid=ir(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){const e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];const n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(ao(s[a].image)):r.push(ao(s[a]))}else r=ao(s);n.url=r}return e||(t.images[this.uuid]=n),n}}function ao(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?qm.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Pt("Texture: Unable to serialize Texture."),{})}let Ym=0;const oo=new F;class Be extends Gi{constructor(t=Be.DEFAULT_IMAGE,e=Be.DEFAULT_MAPPING,n=Jn,s=Jn,r=Fe,a=ui,o=an,l=sn,c=Be.DEFAULT_ANISOTROPY,h=qn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Ym++}),this.uuid=ir(),this.name="",this.source=new Lc(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new Kt(0,0),this.repeat=new Kt(1,1),this.center=new Kt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Dt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(oo).x}get height(){return this.source.getSize(oo).y}get depth(){return this.source.getSize(oo).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(const e in t){const n=t[e];if(n===void 0){Pt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){Pt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];const n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Jd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case va:t.x=t.x-Math.floor(t.x);break;case Jn:t.x=t.x<0?0:1;break;case ul:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case va:t.y=t.y-Math.floor(t.y);break;case Jn:t.y=t.y<0?0:1;break;case ul:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}}Be.DEFAULT_IMAGE=null;Be.DEFAULT_MAPPING=Jd;Be.DEFAULT_ANISOTROPY=1;class de{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=this.w,a=t.elements;return this.x=a[0]*e+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*e+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*e+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*e+a[7]*n+a[11]*s+a[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);const e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r;const l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],m=l[9],x=l[2],g=l[6],p=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-x)<.01&&Math.abs(m-g)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+x)<.1&&Math.abs(m+g)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;const T=(c+1)/2,M=(f+1)/2,A=(p+1)/2,E=(h+d)/4,v=(u+x)/4,y=(m+g)/4;return T>M&&T>A?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=E/n,r=v/n):M>A?M<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=E/s,r=y/s):A<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),n=v/r,s=y/r),this.set(n,s,r,e),this}let S=Math.sqrt((g-m)*(g-m)+(u-x)*(u-x)+(d-h)*(d-h));return Math.abs(S)<.001&&(S=1),this.x=(g-m)/S,this.y=(u-x)/S,this.z=(d-h)/S,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Xt(this.x,t.x,e.x),this.y=Xt(this.y,t.y,e.y),this.z=Xt(this.z,t.z,e.z),this.w=Xt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Xt(this.x,t,e),this.y=Xt(this.y,t,e),this.z=Xt(this.z,t,e),this.w=Xt(this.w,t,e),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Xt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class Km extends Gi{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Fe,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new de(0,0,t,e),this.scissorTest=!1,this.viewport=new de(0,0,t,e),this.textures=[];const s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Be({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){const e={minFilter:Fe,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;const s=Object.assign({},t.textures[e].image);this.textures[e].source=new Lc(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){const e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}}class _n extends Km{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}}class Pc extends Be{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=xe,this.minFilter=xe,this.wrapR=Jn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}}class Zm extends Be{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=xe,this.minFilter=xe,this.wrapR=Jn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}}class Qt{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,a,o,l,c,h,u,d,f,m,x,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,l,c,h,u,d,f,m,x,g)}set(t,e,n,s,r,a,o,l,c,h,u,d,f,m,x,g){const p=this.elements;return p[0]=t,p[4]=e,p[8]=n,p[12]=s,p[1]=r,p[5]=a,p[9]=o,p[13]=l,p[2]=c,p[6]=h,p[10]=u,p[14]=d,p[3]=f,p[7]=m,p[11]=x,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Qt().fromArray(this.elements)}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){const e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){const e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();const e=this.elements,n=t.elements,s=1/Vi.setFromMatrixColumn(t,0).length(),r=1/Vi.setFromMatrixColumn(t,1).length(),a=1/Vi.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*a,e[9]=n[9]*a,e[10]=n[10]*a,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){const e=this.elements,n=t.x,s=t.y,r=t.z,a=Math.cos(n),o=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){const d=a*h,f=a*u,m=o*h,x=o*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=f+m*c,e[5]=d-x*c,e[9]=-o*l,e[2]=x-d*c,e[6]=m+f*c,e[10]=a*l}else if(t.order==="YXZ"){const d=l*h,f=l*u,m=c*h,x=c*u;e[0]=d+x*o,e[4]=m*o-f,e[8]=a*c,e[1]=a*u,e[5]=a*h,e[9]=-o,e[2]=f*o-m,e[6]=x+d*o,e[10]=a*l}else if(t.order==="ZXY"){const d=l*h,f=l*u,m=c*h,x=c*u;e[0]=d-x*o,e[4]=-a*u,e[8]=m+f*o,e[1]=f+m*o,e[5]=a*h,e[9]=x-d*o,e[2]=-a*c,e[6]=o,e[10]=a*l}else if(t.order==="ZYX"){const d=a*h,f=a*u,m=o*h,x=o*u;e[0]=l*h,e[4]=m*c-f,e[8]=d*c+x,e[1]=l*u,e[5]=x*c+d,e[9]=f*c-m,e[2]=-c,e[6]=o*l,e[10]=a*l}else if(t.order==="YZX"){const d=a*l,f=a*c,m=o*l,x=o*c;e[0]=l*h,e[4]=x-d*u,e[8]=m*u+f,e[1]=u,e[5]=a*h,e[9]=-o*h,e[2]=-c*h,e[6]=f*u+m,e[10]=d-x*u}else if(t.order==="XZY"){const d=a*l,f=a*c,m=o*l,x=o*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+x,e[5]=a*h,e[9]=f*u-m,e[2]=m*u-f,e[6]=o*h,e[10]=x*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Jm,t,Qm)}lookAt(t,e,n){const s=this.elements;return We.subVectors(t,e),We.lengthSq()===0&&(We.z=1),We.normalize(),ii.crossVectors(n,We),ii.lengthSq()===0&&(Math.abs(n.z)===1?We.x+=1e-4:We.z+=1e-4,We.normalize(),ii.crossVectors(n,We)),ii.normalize(),ur.crossVectors(We,ii),s[0]=ii.x,s[4]=ur.x,s[8]=We.x,s[1]=ii.y,s[5]=ur.y,s[9]=We.y,s[2]=ii.z,s[6]=ur.z,s[10]=We.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],m=n[2],x=n[6],g=n[10],p=n[14],S=n[3],T=n[7],M=n[11],A=n[15],E=s[0],v=s[4],y=s[8],N=s[12],P=s[1],D=s[5],B=s[9],W=s[13],C=s[2],H=s[6],Z=s[10],G=s[14],et=s[3],X=s[7],Q=s[11],j=s[15];return r[0]=a*E+o*P+l*C+c*et,r[4]=a*v+o*D+l*H+c*X,r[8]=a*y+o*B+l*Z+c*Q,r[12]=a*N+o*W+l*G+c*j,r[1]=h*E+u*P+d*C+f*et,r[5]=h*v+u*D+d*H+f*X,r[9]=h*y+u*B+d*Z+f*Q,r[13]=h*N+u*W+d*G+f*j,r[2]=m*E+x*P+g*C+p*et,r[6]=m*v+x*D+g*H+p*X,r[10]=m*y+x*B+g*Z+p*Q,r[14]=m*N+x*W+g*G+p*j,r[3]=S*E+T*P+M*C+A*et,r[7]=S*v+T*D+M*H+A*X,r[11]=S*y+T*B+M*Z+A*Q,r[15]=S*N+T*W+M*G+A*j,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],a=t[1],o=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],f=t[14],m=t[3],x=t[7],g=t[11],p=t[15],S=l*f-c*d,T=o*f-c*u,M=o*d-l*u,A=a*f-c*h,E=a*d-l*h,v=a*u-o*h;return e*(x*S-g*T+p*M)-n*(m*S-g*A+p*E)+s*(m*T-x*A+p*v)-r*(m*M-x*E+g*v)}determinantAffine(){const t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],a=t[5],o=t[9],l=t[2],c=t[6],h=t[10];return e*(a*h-o*c)-n*(r*h-o*l)+s*(r*c-a*l)}transpose(){const t=this.elements;let e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){const s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],m=t[12],x=t[13],g=t[14],p=t[15],S=e*o-n*a,T=e*l-s*a,M=e*c-r*a,A=n*l-s*o,E=n*c-r*o,v=s*c-r*l,y=h*x-u*m,N=h*g-d*m,P=h*p-f*m,D=u*g-d*x,B=u*p-f*x,W=d*p-f*g,C=S*W-T*B+M*D+A*P-E*N+v*y;if(C===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const H=1/C;return t[0]=(o*W-l*B+c*D)*H,t[1]=(s*B-n*W-r*D)*H,t[2]=(x*v-g*E+p*A)*H,t[3]=(d*E-u*v-f*A)*H,t[4]=(l*P-a*W-c*N)*H,t[5]=(e*W-s*P+r*N)*H,t[6]=(g*M-m*v-p*T)*H,t[7]=(h*v-d*M+f*T)*H,t[8]=(a*B-o*P+c*y)*H,t[9]=(n*P-e*B-r*y)*H,t[10]=(m*E-x*M+p*S)*H,t[11]=(u*M-h*E-f*S)*H,t[12]=(o*N-a*D-l*y)*H,t[13]=(e*D-n*N+s*y)*H,t[14]=(x*T-m*A-g*S)*H,t[15]=(h*A-u*T+d*S)*H,this}scale(t){const e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){const t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){const e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){const n=Math.cos(e),s=Math.sin(e),r=1-n,a=t.x,o=t.y,l=t.z,c=r*a,h=r*o;return this.set(c*a+n,c*o-s*l,c*l+s*o,0,c*o+s*l,h*o+n,h*l-s*a,0,c*l-s*o,h*l+s*a,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,a){return this.set(1,n,r,0,t,1,a,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){const s=this.elements,r=e._x,a=e._y,o=e._z,l=e._w,c=r+r,h=a+a,u=o+o,d=r*c,f=r*h,m=r*u,x=a*h,g=a*u,p=o*u,S=l*c,T=l*h,M=l*u,A=n.x,E=n.y,v=n.z;return s[0]=(1-(x+p))*A,s[1]=(f+M)*A,s[2]=(m-T)*A,s[3]=0,s[4]=(f-M)*E,s[5]=(1-(d+p))*E,s[6]=(g+S)*E,s[7]=0,s[8]=(m+T)*v,s[9]=(g-S)*v,s[10]=(1-(d+x))*v,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){const s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];const r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let a=Vi.set(s[0],s[1],s[2]).length();const o=Vi.set(s[4],s[5],s[6]).length(),l=Vi.set(s[8],s[9],s[10]).length();r<0&&(a=-a),hn.copy(this);const c=1/a,h=1/o,u=1/l;return hn.elements[0]*=c,hn.elements[1]*=c,hn.elements[2]*=c,hn.elements[4]*=h,hn.elements[5]*=h,hn.elements[6]*=h,hn.elements[8]*=u,hn.elements[9]*=u,hn.elements[10]*=u,e.setFromRotationMatrix(hn),n.x=a,n.y=o,n.z=l,this}makePerspective(t,e,n,s,r,a,o=gn,l=!1){const c=this.elements,h=2*r/(e-t),u=2*r/(n-s),d=(e+t)/(e-t),f=(n+s)/(n-s);let m,x;if(l)m=r/(a-r),x=a*r/(a-r);else if(o===gn)m=-(a+r)/(a-r),x=-2*a*r/(a-r);else if(o===Ma)m=-a/(a-r),x=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,a,o=gn,l=!1){const c=this.elements,h=2/(e-t),u=2/(n-s),d=-(e+t)/(e-t),f=-(n+s)/(n-s);let m,x;if(l)m=1/(a-r),x=a/(a-r);else if(o===gn)m=-2/(a-r),x=-(a+r)/(a-r);else if(o===Ma)m=-1/(a-r),x=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}}const Vi=new F,hn=new Qt,Jm=new F(0,0,0),Qm=new F(1,1,1),ii=new F,ur=new F,We=new F,Ih=new Qt,Dh=new gs;class Oi{constructor(t=0,e=0,n=0,s=Oi.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){const s=t.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Xt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Xt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(Xt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Xt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(Xt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(o,f));break;case"XZY":this._z=Math.asin(-Xt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Pt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return Ih.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Ih,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Dh.setFromEuler(this),this.setFromQuaternion(Dh,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}Oi.DEFAULT_ORDER="XYZ";class cf{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}}let jm=0;const Nh=new F,Wi=new gs,kn=new Qt,dr=new F,ws=new F,t0=new F,e0=new gs,Uh=new F(1,0,0),Fh=new F(0,1,0),Oh=new F(0,0,1),kh={type:"added"},n0={type:"removed"},Xi={type:"childadded",child:null},lo={type:"childremoved",child:null};class Ke extends Gi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:jm++}),this.uuid=ir(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=Ke.DEFAULT_UP.clone();const t=new F,e=new Oi,n=new gs,s=new F(1,1,1);function r(){n.setFromEuler(e,!1)}function a(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Qt},normalMatrix:{value:new Dt}}),this.matrix=new Qt,this.matrixWorld=new Qt,this.matrixAutoUpdate=Ke.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=Ke.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new cf,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Wi.setFromAxisAngle(t,e),this.quaternion.multiply(Wi),this}rotateOnWorldAxis(t,e){return Wi.setFromAxisAngle(t,e),this.quaternion.premultiply(Wi),this}rotateX(t){return this.rotateOnAxis(Uh,t)}rotateY(t){return this.rotateOnAxis(Fh,t)}rotateZ(t){return this.rotateOnAxis(Oh,t)}translateOnAxis(t,e){return Nh.copy(t).applyQuaternion(this.quaternion),this.position.add(Nh.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Uh,t)}translateY(t){return this.translateOnAxis(Fh,t)}translateZ(t){return this.translateOnAxis(Oh,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(kn.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?dr.copy(t):dr.set(t,e,n);const s=this.parent;this.updateWorldMatrix(!0,!1),ws.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?kn.lookAt(ws,dr,this.up):kn.lookAt(dr,ws,this.up),this.quaternion.setFromRotationMatrix(kn),s&&(kn.extractRotation(s.matrixWorld),Wi.setFromRotationMatrix(kn),this.quaternion.premultiply(Wi.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Jt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(kh),Xi.child=t,this.dispatchEvent(Xi),Xi.child=null):Jt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}const e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(n0),lo.child=t,this.dispatchEvent(lo),lo.child=null),this}removeFromParent(){const t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),kn.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),kn.multiply(t.parent.matrixWorld)),t.applyMatrix4(kn),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(kh),Xi.child=t,this.dispatchEvent(Xi),Xi.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){const a=this.children[n].getObjectByProperty(t,e);if(a!==void 0)return a}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);const s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ws,t,t0),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ws,e0,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);const e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){const e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);const t=this.pivot;if(t!==null){const e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){const s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){const r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(t){const e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);const o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){const l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){const u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(t.materials,this.material[l]));s.material=o}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){const l=this.animations[o];s.animations.push(r(t.animations,l))}}if(e){const o=a(t.geometries),l=a(t.materials),c=a(t.textures),h=a(t.images),u=a(t.shapes),d=a(t.skeletons),f=a(t.animations),m=a(t.nodes);o.length>0&&(n.geometries=o),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),m.length>0&&(n.nodes=m)}return n.object=s,n;function a(o){const l=[];for(const c in o){const h=o[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){const s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}}Ke.DEFAULT_UP=new F(0,1,0);Ke.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ke.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;class fr extends Ke{constructor(){super(),this.isGroup=!0,this.type="Group"}}const i0={type:"move"};class co{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new fr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new fr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new F,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new F),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new fr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new F,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new F,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){const e=this._hand;if(e)for(const n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,a=null;const o=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){a=!0;for(const x of t.hand.values()){const g=e.getJointPose(x,n),p=this._getHandJoint(c,x);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}const h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,m=.005;c.inputState.pinching&&d>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));o!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(i0)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){const n=new fr;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}}const hf={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},si={h:0,s:0,l:0},pr={h:0,s:0,l:0};function ho(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}class Gt{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){const s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=nn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,qt.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=qt.workingColorSpace){return this.r=t,this.g=e,this.b=n,qt.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=qt.workingColorSpace){if(t=Gm(t,1),e=Xt(e,0,1),n=Xt(n,0,1),e===0)this.r=this.g=this.b=n;else{const r=n<=.5?n*(1+e):n+e-n*e,a=2*n-r;this.r=ho(a,r,t+1/3),this.g=ho(a,r,t),this.b=ho(a,r,t-1/3)}return qt.colorSpaceToWorking(this,s),this}setStyle(t,e=nn){function n(r){r!==void 0&&parseFloat(r)<1&&Pt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r;const a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Pt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){const r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(a===6)return this.setHex(parseInt(r,16),e);Pt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=nn){const n=hf[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Pt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=jn(t.r),this.g=jn(t.g),this.b=jn(t.b),this}copyLinearToSRGB(t){return this.r=ls(t.r),this.g=ls(t.g),this.b=ls(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=nn){return qt.workingToColorSpace(Ue.copy(this),t),Math.round(Xt(Ue.r*255,0,255))*65536+Math.round(Xt(Ue.g*255,0,255))*256+Math.round(Xt(Ue.b*255,0,255))}getHexString(t=nn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=qt.workingColorSpace){qt.workingToColorSpace(Ue.copy(this),e);const n=Ue.r,s=Ue.g,r=Ue.b,a=Math.max(n,s,r),o=Math.min(n,s,r);let l,c;const h=(o+a)/2;if(o===a)l=0,c=0;else{const u=a-o;switch(c=h<=.5?u/(a+o):u/(2-a-o),a){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=qt.workingColorSpace){return qt.workingToColorSpace(Ue.copy(this),e),t.r=Ue.r,t.g=Ue.g,t.b=Ue.b,t}getStyle(t=nn){qt.workingToColorSpace(Ue.copy(this),t);const e=Ue.r,n=Ue.g,s=Ue.b;return t!==nn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(si),this.setHSL(si.h+t,si.s+e,si.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(si),t.getHSL(pr);const n=io(si.h,pr.h,e),s=io(si.s,pr.s,e),r=io(si.l,pr.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){const e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const Ue=new Gt;Gt.NAMES=hf;class $s extends Ke{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Oi,this.environmentIntensity=1,this.environmentRotation=new Oi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){const e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}}const un=new F,Bn=new F,uo=new F,zn=new F,qi=new F,$i=new F,Bh=new F,fo=new F,po=new F,mo=new F,go=new de,vo=new de,_o=new de;class mn{constructor(t=new F,e=new F,n=new F){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),un.subVectors(t,e),s.cross(un);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){un.subVectors(s,e),Bn.subVectors(n,e),uo.subVectors(t,e);const a=un.dot(un),o=un.dot(Bn),l=un.dot(uo),c=Bn.dot(Bn),h=Bn.dot(uo),u=a*c-o*o;if(u===0)return r.set(0,0,0),null;const d=1/u,f=(c*l-o*h)*d,m=(a*h-o*l)*d;return r.set(1-f-m,m,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,zn)===null?!1:zn.x>=0&&zn.y>=0&&zn.x+zn.y<=1}static getInterpolation(t,e,n,s,r,a,o,l){return this.getBarycoord(t,e,n,s,zn)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,zn.x),l.addScaledVector(a,zn.y),l.addScaledVector(o,zn.z),l)}static getInterpolatedAttribute(t,e,n,s,r,a){return go.setScalar(0),vo.setScalar(0),_o.setScalar(0),go.fromBufferAttribute(t,e),vo.fromBufferAttribute(t,n),_o.fromBufferAttribute(t,s),a.setScalar(0),a.addScaledVector(go,r.x),a.addScaledVector(vo,r.y),a.addScaledVector(_o,r.z),a}static isFrontFacing(t,e,n,s){return un.subVectors(n,e),Bn.subVectors(t,e),un.cross(Bn).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return un.subVectors(this.c,this.b),Bn.subVectors(this.a,this.b),un.cross(Bn).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return mn.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return mn.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return mn.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return mn.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return mn.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){const n=this.a,s=this.b,r=this.c;let a,o;qi.subVectors(s,n),$i.subVectors(r,n),fo.subVectors(t,n);const l=qi.dot(fo),c=$i.dot(fo);if(l<=0&&c<=0)return e.copy(n);po.subVectors(t,s);const h=qi.dot(po),u=$i.dot(po);if(h>=0&&u<=h)return e.copy(s);const d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return a=l/(l-h),e.copy(n).addScaledVector(qi,a);mo.subVectors(t,r);const f=qi.dot(mo),m=$i.dot(mo);if(m>=0&&f<=m)return e.copy(r);const x=f*c-l*m;if(x<=0&&c>=0&&m<=0)return o=c/(c-m),e.copy(n).addScaledVector($i,o);const g=h*m-f*u;if(g<=0&&u-h>=0&&f-m>=0)return Bh.subVectors(r,s),o=(u-h)/(u-h+(f-m)),e.copy(s).addScaledVector(Bh,o);const p=1/(g+x+d);return a=x*p,o=d*p,e.copy(n).addScaledVector(qi,a).addScaledVector($i,o)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}}class sr{constructor(t=new F(1/0,1/0,1/0),e=new F(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(dn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(dn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){const n=dn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);const n=t.geometry;if(n!==void 0){const r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)t.isMesh===!0?t.getVertexPosition(a,dn):dn.fromBufferAttribute(r,a),dn.applyMatrix4(t.matrixWorld),this.expandByPoint(dn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),mr.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),mr.copy(n.boundingBox)),mr.applyMatrix4(t.matrixWorld),this.union(mr)}const s=t.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,dn),dn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Ss),gr.subVectors(this.max,Ss),Yi.subVectors(t.a,Ss),Ki.subVectors(t.b,Ss),Zi.subVectors(t.c,Ss),ri.subVectors(Ki,Yi),ai.subVectors(Zi,Ki),yi.subVectors(Yi,Zi);let e=[0,-ri.z,ri.y,0,-ai.z,ai.y,0,-yi.z,yi.y,ri.z,0,-ri.x,ai.z,0,-ai.x,yi.z,0,-yi.x,-ri.y,ri.x,0,-ai.y,ai.x,0,-yi.y,yi.x,0];return!xo(e,Yi,Ki,Zi,gr)||(e=[1,0,0,0,1,0,0,0,1],!xo(e,Yi,Ki,Zi,gr))?!1:(vr.crossVectors(ri,ai),e=[vr.x,vr.y,vr.z],xo(e,Yi,Ki,Zi,gr))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,dn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(dn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Gn[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Gn[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Gn[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Gn[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Gn[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Gn[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Gn[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Gn[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Gn),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}}const Gn=[new F,new F,new F,new F,new F,new F,new F,new F],dn=new F,mr=new sr,Yi=new F,Ki=new F,Zi=new F,ri=new F,ai=new F,yi=new F,Ss=new F,gr=new F,vr=new F,Ei=new F;function xo(i,t,e,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){Ei.fromArray(i,r);const o=s.x*Math.abs(Ei.x)+s.y*Math.abs(Ei.y)+s.z*Math.abs(Ei.z),l=t.dot(Ei),c=e.dot(Ei),h=n.dot(Ei);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}const $n=s0();function s0(){const i=new ArrayBuffer(4),t=new Float32Array(i),e=new Uint32Array(i),n=new Uint32Array(512),s=new Uint32Array(512);for(let l=0;l<256;++l){const c=l-127;c<-27?(n[l]=0,n[l|256]=32768,s[l]=24,s[l|256]=24):c<-14?(n[l]=1024>>-c-14,n[l|256]=1024>>-c-14|32768,s[l]=-c-1,s[l|256]=-c-1):c<=15?(n[l]=c+15<<10,n[l|256]=c+15<<10|32768,s[l]=13,s[l|256]=13):c<128?(n[l]=31744,n[l|256]=64512,s[l]=24,s[l|256]=24):(n[l]=31744,n[l|256]=64512,s[l]=13,s[l|256]=13)}const r=new Uint32Array(2048),a=new Uint32Array(64),o=new Uint32Array(64);for(let l=1;l<1024;++l){let c=l<<13,h=0;for(;(c&8388608)===0;)c<<=1,h-=8388608;c&=-8388609,h+=947912704,r[l]=c|h}for(let l=1024;l<2048;++l)r[l]=939524096+(l-1024<<13);for(let l=1;l<31;++l)a[l]=l<<23;a[31]=1199570944,a[32]=2147483648;for(let l=33;l<63;++l)a[l]=2147483648+(l-32<<23);a[63]=3347054592;for(let l=1;l<64;++l)l!==32&&(o[l]=1024);return{floatView:t,uint32View:e,baseTable:n,shiftTable:s,mantissaTable:r,exponentTable:a,offsetTable:o}}function r0(i){Math.abs(i)>65504&&Pt("DataUtils.toHalfFloat(): Value out of range."),i=Xt(i,-65504,65504),$n.floatView[0]=i;const t=$n.uint32View[0],e=t>>23&511;return $n.baseTable[e]+((t&8388607)>>$n.shiftTable[e])}function a0(i){const t=i>>10;return $n.uint32View[0]=$n.mantissaTable[$n.offsetTable[t]+(i&1023)]+$n.exponentTable[t],$n.floatView[0]}class uf{static toHalfFloat(t){return r0(t)}static fromHalfFloat(t){return a0(t)}}const ge=new F,_r=new Kt;let o0=0;class on extends Gi{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:o0++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Fm,this.updateRanges=[],this.gpuType=rn,this.version=0,this._normalizationScale=t!==void 0?Cc(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)_r.fromBufferAttribute(this,e),_r.applyMatrix3(t),this.setXY(e,_r.x,_r.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)ge.fromBufferAttribute(this,e),ge.applyMatrix3(t),this.setXYZ(e,ge.x,ge.y,ge.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)ge.fromBufferAttribute(this,e),ge.applyMatrix4(t),this.setXYZ(e,ge.x,ge.y,ge.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)ge.fromBufferAttribute(this,e),ge.applyNormalMatrix(t),this.setXYZ(e,ge.x,ge.y,ge.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)ge.fromBufferAttribute(this,e),ge.transformDirection(t),this.setXYZ(e,ge.x,ge.y,ge.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){const e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Vm(t,this.array)}_normalize(t){const e=this._normalizationScale;return e!==void 0?Math.round(t*e):Wm(t,this.array)}}class df extends on{constructor(t,e,n){super(new Uint16Array(t),e,n)}}class ff extends on{constructor(t,e,n){super(new Uint32Array(t),e,n)}}class ti extends on{constructor(t,e,n){super(new Float32Array(t),e,n)}}const l0=new sr,Ms=new F,wo=new F;class Ic{constructor(t=new F,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){const n=this.center;e!==void 0?n.copy(e):l0.setFromPoints(t).getCenter(n);let s=0;for(let r=0,a=t.length;r<a;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){const e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){const n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Ms.subVectors(t,this.center);const e=Ms.lengthSq();if(e>this.radius*this.radius){const n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Ms,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(wo.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Ms.copy(t.center).add(wo)),this.expandByPoint(Ms.copy(t.center).sub(wo))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}}let c0=0;const tn=new Qt,So=new Ke,Ji=new F,Xe=new sr,ys=new sr,Ae=new F;class Fn extends Gi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:c0++}),this.uuid=ir(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Om(t)?ff:df)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){const e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);const n=this.attributes.normal;if(n!==void 0){const r=new Dt().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return tn.makeRotationFromQuaternion(t),this.applyMatrix4(tn),this}rotateX(t){return tn.makeRotationX(t),this.applyMatrix4(tn),this}rotateY(t){return tn.makeRotationY(t),this.applyMatrix4(tn),this}rotateZ(t){return tn.makeRotationZ(t),this.applyMatrix4(tn),this}translate(t,e,n){return tn.makeTranslation(t,e,n),this.applyMatrix4(tn),this}scale(t,e,n){return tn.makeScale(t,e,n),this.applyMatrix4(tn),this}lookAt(t){return So.lookAt(t),So.updateMatrix(),this.applyMatrix4(So.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ji).negate(),this.translate(Ji.x,Ji.y,Ji.z),this}setFromPoints(t){const e=this.getAttribute("position");if(e===void 0){const n=[];for(let s=0,r=t.length;s<r;s++){const a=t[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new ti(n,3))}else{const n=Math.min(t.length,e.count);for(let s=0;s<n;s++){const r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Pt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new sr);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Jt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new F(-1/0,-1/0,-1/0),new F(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){const r=e[n];Xe.setFromBufferAttribute(r),this.morphTargetsRelative?(Ae.addVectors(this.boundingBox.min,Xe.min),this.boundingBox.expandByPoint(Ae),Ae.addVectors(this.boundingBox.max,Xe.max),this.boundingBox.expandByPoint(Ae)):(this.boundingBox.expandByPoint(Xe.min),this.boundingBox.expandByPoint(Xe.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Jt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ic);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Jt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new F,1/0);return}if(t){const n=this.boundingSphere.center;if(Xe.setFromBufferAttribute(t),e)for(let r=0,a=e.length;r<a;r++){const o=e[r];ys.setFromBufferAttribute(o),this.morphTargetsRelative?(Ae.addVectors(Xe.min,ys.min),Xe.expandByPoint(Ae),Ae.addVectors(Xe.max,ys.max),Xe.expandByPoint(Ae)):(Xe.expandByPoint(ys.min),Xe.expandByPoint(ys.max))}Xe.getCenter(n);let s=0;for(let r=0,a=t.count;r<a;r++)Ae.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Ae));if(e)for(let r=0,a=e.length;r<a;r++){const o=e[r],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)Ae.fromBufferAttribute(o,c),l&&(Ji.fromBufferAttribute(t,c),Ae.add(Ji)),s=Math.max(s,n.distanceToSquared(Ae))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Jt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Jt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const n=e.position,s=e.normal,r=e.uv;let a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new on(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));const o=[],l=[],c=new Uint8Array(n.count);for(let N=0;N<n.count;N++)o[N]=new F,l[N]=new F;const h=new F,u=new F,d=new F,f=new Kt,m=new Kt,x=new Kt,g=new F,p=new F;function S(N,P,D){c[N]=c[P]=c[D]=1,h.fromBufferAttribute(n,N),u.fromBufferAttribute(n,P),d.fromBufferAttribute(n,D),f.fromBufferAttribute(r,N),m.fromBufferAttribute(r,P),x.fromBufferAttribute(r,D),u.sub(h),d.sub(h),m.sub(f),x.sub(f);const B=1/(m.x*x.y-x.x*m.y);isFinite(B)&&(g.copy(u).multiplyScalar(x.y).addScaledVector(d,-m.y).multiplyScalar(B),p.copy(d).multiplyScalar(m.x).addScaledVector(u,-x.x).multiplyScalar(B),o[N].add(g),o[P].add(g),o[D].add(g),l[N].add(p),l[P].add(p),l[D].add(p))}let T=this.groups;T.length===0&&(T=[{start:0,count:t.count}]);for(let N=0,P=T.length;N<P;++N){const D=T[N],B=D.start,W=D.count;for(let C=B,H=B+W;C<H;C+=3)S(t.getX(C+0),t.getX(C+1),t.getX(C+2))}const M=new F,A=new F,E=new F,v=new F;function y(N){E.fromBufferAttribute(s,N),v.copy(E);const P=o[N];M.copy(P),M.sub(E.multiplyScalar(E.dot(P))).normalize(),A.crossVectors(v,P);const B=A.dot(l[N])<0?-1:1;a.setXYZW(N,M.x,M.y,M.z,B)}for(let N=0,P=n.count;N<P;++N)c[N]&&y(N);this._transformed=!0}computeVertexNormals(){const t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new on(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);const s=new F,r=new F,a=new F,o=new F,l=new F,c=new F,h=new F,u=new F;if(t)for(let d=0,f=t.count;d<f;d+=3){const m=t.getX(d+0),x=t.getX(d+1),g=t.getX(d+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,x),a.fromBufferAttribute(e,g),h.subVectors(a,r),u.subVectors(s,r),h.cross(u),o.fromBufferAttribute(n,m),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,g),o.add(h),l.add(h),c.add(h),n.setXYZ(m,o.x,o.y,o.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),a.fromBufferAttribute(e,d+2),h.subVectors(a,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){const t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Ae.fromBufferAttribute(t,e),Ae.normalize(),t.setXYZ(e,Ae.x,Ae.y,Ae.z)}toNonIndexed(){function t(o,l){const c=o.array,h=o.itemSize,u=o.normalized,d=new c.constructor(l.length*h);let f=0,m=0;for(let x=0,g=l.length;x<g;x++){o.isInterleavedBufferAttribute?f=l[x]*o.data.stride+o.offset:f=l[x]*h;for(let p=0;p<h;p++)d[m++]=c[f++]}return new on(d,h,u)}if(this.index===null)return Pt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const e=new Fn,n=this.index.array,s=this.attributes;for(const o in s){const l=s[o],c=t(l,n);e.setAttribute(o,c)}const r=this.morphAttributes;for(const o in r){const l=[],c=r[o];for(let h=0,u=c.length;h<u;h++){const d=c[h],f=t(d,n);l.push(f)}e.morphAttributes[o]=l}e.morphTargetsRelative=this.morphTargetsRelative;const a=this.groups;for(let o=0,l=a.length;o<l;o++){const c=a[o];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){const t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};const e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});const n=this.attributes;for(const l in n){const c=n[l];t.data.attributes[l]=c.toJSON(t.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){const f=c[u];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);const a=this.groups;a.length>0&&(t.data.groups=JSON.parse(JSON.stringify(a)));const o=this.boundingSphere;return o!==null&&(t.data.boundingSphere=o.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const e={};this.name=t.name;const n=t.index;n!==null&&this.setIndex(n.clone());const s=t.attributes;for(const c in s){const h=s[c];this.setAttribute(c,h.clone(e))}const r=t.morphAttributes;for(const c in r){const h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;const a=t.groups;for(let c=0,h=a.length;c<h;c++){const u=a[c];this.addGroup(u.start,u.count,u.materialIndex)}const o=t.boundingBox;o!==null&&(this.boundingBox=o.clone());const l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}}const Mo=new F,h0=new F,u0=new Dt;class ci{constructor(t=new F(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){const s=Mo.subVectors(n,e).cross(h0.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){const t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){const s=t.delta(Mo),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;const a=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:e.copy(t.start).addScaledVector(s,a)}intersectsLine(t){const e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){const n=e||u0.getNormalMatrix(t),s=this.coplanarPoint(Mo).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}}let d0=0;class Ga extends Gi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:d0++}),this.uuid=ir(),this.name="",this.type="Material",this.blending=qs,this.side=mi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Gd,this.blendDst=Hd,this.blendEquation=es,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Gt(0,0,0),this.blendAlpha=0,this.depthFunc=js,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Lm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=eo,this.stencilZFail=eo,this.stencilZPass=eo,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(const e in t){const n=t[e];if(n===void 0){Pt(`Material: parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){Pt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){const e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});const n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){const a=[];for(const o in r){const l=r[o];delete l.metadata,a.push(l)}return a}if(e){const r=s(t.textures),a=s(t.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Gt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new ci().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Kt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Kt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;const e=t.clippingPlanes;let n=null;if(e!==null){const s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}}const Hn=new F,yo=new F,xr=new F,wr=new F;class f0{constructor(t=new F,e=new F(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Hn)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);const n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){const e=Hn.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Hn.copy(this.origin).addScaledVector(this.direction,e),Hn.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){yo.copy(t).add(e).multiplyScalar(.5),xr.copy(e).sub(t).normalize(),wr.copy(this.origin).sub(yo);const r=t.distanceTo(e)*.5,a=-this.direction.dot(xr),o=wr.dot(this.direction),l=-wr.dot(xr),c=wr.lengthSq(),h=Math.abs(1-a*a);let u,d,f,m;if(h>0)if(u=a*l-o,d=a*o-l,m=r*h,u>=0)if(d>=-m)if(d<=m){const x=1/h;u*=x,d*=x,f=u*(u+a*d+2*o)+d*(a*u+d+2*l)+c}else d=r,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*l)+c;else d<=-m?(u=Math.max(0,-(-a*r+o)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=m?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(a*r+o)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=a>0?-r:r,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(yo).addScaledVector(xr,d),f}intersectSphere(t,e){if(t.radius<0)return null;Hn.subVectors(t.center,this.origin);const n=Hn.dot(this.direction),s=Hn.dot(Hn)-n*n,r=t.radius*t.radius;if(s>r)return null;const a=Math.sqrt(r-s),o=n-a,l=n+a;return l<0?null:o<0?this.at(l,e):this.at(o,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){const e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;const n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){const n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){const e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,a,o,l;const c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(n=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,a=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,a=(t.min.y-d.y)*h),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),u>=0?(o=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(o=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),n>l||o>s)||((o>n||n!==n)&&(n=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Hn)!==null}intersectTriangle(t,e,n,s,r){const a=this.origin,o=this.direction,l=o.x,c=o.y,h=o.z,u=t.x-a.x,d=t.y-a.y,f=t.z-a.z,m=e.x-a.x,x=e.y-a.y,g=e.z-a.z,p=n.x-a.x,S=n.y-a.y,T=n.z-a.z,M=Math.abs(l),A=Math.abs(c),E=Math.abs(h);let v,y,N,P,D,B,W,C,H,Z,G,et;if(M>=A&&M>=E?(N=l,B=u,H=m,et=p,l>=0?(v=c,y=h,P=d,D=f,W=x,C=g,Z=S,G=T):(v=h,y=c,P=f,D=d,W=g,C=x,Z=T,G=S)):A>=E?(N=c,B=d,H=x,et=S,c>=0?(v=h,y=l,P=f,D=u,W=g,C=m,Z=T,G=p):(v=l,y=h,P=u,D=f,W=m,C=g,Z=p,G=T)):(N=h,B=f,H=g,et=T,h>=0?(v=l,y=c,P=u,D=d,W=m,C=x,Z=p,G=S):(v=c,y=l,P=d,D=u,W=x,C=m,Z=S,G=p)),N===0)return null;const X=v/N,Q=y/N,j=1/N,Mt=P-X*B,Nt=D-Q*B,Y=W-X*H,pt=C-Q*H,xt=Z-X*et,Rt=G-Q*et,gt=xt*pt-Rt*Y,Ft=Mt*Rt-Nt*xt,pe=Y*Nt-pt*Mt;if(s){if(gt<0||Ft<0||pe<0)return null}else if((gt<0||Ft<0||pe<0)&&(gt>0||Ft>0||pe>0))return null;const Lt=gt+Ft+pe;if(Lt===0)return null;const te=j*(gt*B+Ft*H+pe*et);return(Lt>0?te<0:te>0)?null:this.at(te/Lt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class p0 extends Ga{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Gt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Oi,this.combine=Vd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}}const zh=new Qt,bi=new f0,Sr=new Ic,Gh=new F,Mr=new F,yr=new F,Er=new F,Eo=new F,br=new F,Hh=new F,Tr=new F;class Nn extends Ke{constructor(t=new Fn,e=new p0){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){const o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(t,e){const n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;e.fromBufferAttribute(s,t);const o=this.morphTargetInfluences;if(r&&o){br.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const h=o[l],u=r[l];h!==0&&(Eo.fromBufferAttribute(u,t),a?br.addScaledVector(Eo,h):br.addScaledVector(Eo.sub(e),h))}e.add(br)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){const n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Sr.copy(n.boundingSphere),Sr.applyMatrix4(r),bi.copy(t.ray).recast(t.near),!(Sr.containsPoint(bi.origin)===!1&&(bi.intersectSphere(Sr,Gh)===null||bi.origin.distanceToSquared(Gh)>(t.far-t.near)**2))&&(zh.copy(r).invert(),bi.copy(t.ray).applyMatrix4(zh),!(n.boundingBox!==null&&bi.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,bi)))}_computeIntersections(t,e,n){let s;const r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(o!==null)if(Array.isArray(a))for(let m=0,x=d.length;m<x;m++){const g=d[m],p=a[g.materialIndex],S=Math.max(g.start,f.start),T=Math.min(o.count,Math.min(g.start+g.count,f.start+f.count));for(let M=S,A=T;M<A;M+=3){const E=o.getX(M),v=o.getX(M+1),y=o.getX(M+2);s=Ar(this,p,t,n,c,h,u,E,v,y),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{const m=Math.max(0,f.start),x=Math.min(o.count,f.start+f.count);for(let g=m,p=x;g<p;g+=3){const S=o.getX(g),T=o.getX(g+1),M=o.getX(g+2);s=Ar(this,a,t,n,c,h,u,S,T,M),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let m=0,x=d.length;m<x;m++){const g=d[m],p=a[g.materialIndex],S=Math.max(g.start,f.start),T=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let M=S,A=T;M<A;M+=3){const E=M,v=M+1,y=M+2;s=Ar(this,p,t,n,c,h,u,E,v,y),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{const m=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let g=m,p=x;g<p;g+=3){const S=g,T=g+1,M=g+2;s=Ar(this,a,t,n,c,h,u,S,T,M),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}}function m0(i,t,e,n,s,r,a,o){let l;if(t.side===Ve?l=n.intersectTriangle(a,r,s,!0,o):l=n.intersectTriangle(s,r,a,t.side===mi,o),l===null)return null;Tr.copy(o),Tr.applyMatrix4(i.matrixWorld);const c=e.ray.origin.distanceTo(Tr);return c<e.near||c>e.far?null:{distance:c,point:Tr.clone(),object:i}}function Ar(i,t,e,n,s,r,a,o,l,c){i.getVertexPosition(o,Mr),i.getVertexPosition(l,yr),i.getVertexPosition(c,Er);const h=m0(i,t,e,n,Mr,yr,Er,Hh);if(h){const u=new F;mn.getBarycoord(Hh,Mr,yr,Er,u),s&&(h.uv=mn.getInterpolatedAttribute(s,o,l,c,u,new Kt)),r&&(h.uv1=mn.getInterpolatedAttribute(r,o,l,c,u,new Kt)),a&&(h.normal=mn.getInterpolatedAttribute(a,o,l,c,u,new F),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));const d={a:o,b:l,c,normal:new F,materialIndex:0};mn.getNormal(Mr,yr,Er,d.normal),h.face=d,h.barycoord=u}return h}class Ha extends Be{constructor(t=null,e=1,n=1,s,r,a,o,l,c=xe,h=xe,u,d){super(null,a,o,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}const Ti=new Ic,g0=new Kt(.5,.5),Rr=new F;class Ea{constructor(t=new ci,e=new ci,n=new ci,s=new ci,r=new ci,a=new ci){this.planes=[t,e,n,s,r,a]}set(t,e,n,s,r,a){const o=this.planes;return o[0].copy(t),o[1].copy(e),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(t){const e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=gn,n=!1){const s=this.planes,r=t.elements,a=r[0],o=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],m=r[8],x=r[9],g=r[10],p=r[11],S=r[12],T=r[13],M=r[14],A=r[15];if(s[0].setComponents(c-a,f-h,p-m,A-S).normalize(),s[1].setComponents(c+a,f+h,p+m,A+S).normalize(),s[2].setComponents(c+o,f+u,p+x,A+T).normalize(),s[3].setComponents(c-o,f-u,p-x,A-T).normalize(),n)s[4].setComponents(l,d,g,M).normalize(),s[5].setComponents(c-l,f-d,p-g,A-M).normalize();else if(s[4].setComponents(c-l,f-d,p-g,A-M).normalize(),e===gn)s[5].setComponents(c+l,f+d,p+g,A+M).normalize();else if(e===Ma)s[5].setComponents(l,d,g,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ti.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{const e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ti.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ti)}intersectsSprite(t){Ti.center.set(0,0,0);const e=g0.distanceTo(t.center);return Ti.radius=.7071067811865476+e,Ti.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ti)}intersectsSphere(t){const e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){const e=this.planes;for(let n=0;n<6;n++){const s=e[n];if(Rr.x=s.normal.x>0?t.max.x:t.min.x,Rr.y=s.normal.y>0?t.max.y:t.min.y,Rr.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Rr)<0)return!1}return!0}containsPoint(t){const e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}const Vh=new Qt;class Dc{constructor(){this.coordinateSystem=gn,this._frustums=[],this._count=0}setFromArrayCamera(t){const e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){const r=e[s];Vh.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Ea),n[s].setFromProjectionMatrix(Vh,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){const e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){const e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){const e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){const e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){const e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;const e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Ea),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new Dc().copy(this)}}class pf extends Be{constructor(t=[],e=hs,n,s,r,a,o,l,c,h){super(t,e,n,s,r,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}}class ki extends Be{constructor(t,e,n=ln,s,r,a,o=xe,l=xe,c,h=gi,u=1){if(h!==gi&&h!==di)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");const d={width:t,height:e,depth:u};super(d,s,r,a,o,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Lc(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){const e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}}class mf extends ki{constructor(t,e=ln,n=hs,s,r,a=xe,o=xe,l,c=gi){const h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,a,o,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}}class gf extends Be{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}}class rr extends Fn{constructor(t=1,e=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};const o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);const l=[],c=[],h=[],u=[];let d=0,f=0;m("z","y","x",-1,-1,n,e,t,a,r,0),m("z","y","x",1,-1,n,e,-t,a,r,1),m("x","z","y",1,1,t,n,e,s,a,2),m("x","z","y",1,-1,t,n,-e,s,a,3),m("x","y","z",1,-1,t,e,n,s,r,4),m("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new ti(c,3)),this.setAttribute("normal",new ti(h,3)),this.setAttribute("uv",new ti(u,2));function m(x,g,p,S,T,M,A,E,v,y,N){const P=M/v,D=A/y,B=M/2,W=A/2,C=E/2,H=v+1,Z=y+1;let G=0,et=0;const X=new F;for(let Q=0;Q<Z;Q++){const j=Q*D-W;for(let Mt=0;Mt<H;Mt++){const Nt=Mt*P-B;X[x]=Nt*S,X[g]=j*T,X[p]=C,c.push(X.x,X.y,X.z),X[x]=0,X[g]=0,X[p]=E>0?1:-1,h.push(X.x,X.y,X.z),u.push(Mt/v),u.push(1-Q/y),G+=1}}for(let Q=0;Q<y;Q++)for(let j=0;j<v;j++){const Mt=d+j+H*Q,Nt=d+j+H*(Q+1),Y=d+(j+1)+H*(Q+1),pt=d+(j+1)+H*Q;l.push(Mt,Nt,pt),l.push(Nt,Y,pt),et+=6}o.addGroup(f,et,N),f+=et,d+=G}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new rr(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}}class Va extends Fn{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};const r=t/2,a=e/2,o=Math.floor(n),l=Math.floor(s),c=o+1,h=l+1,u=t/o,d=e/l,f=[],m=[],x=[],g=[];for(let p=0;p<h;p++){const S=p*d-a;for(let T=0;T<c;T++){const M=T*u-r;m.push(M,-S,0),x.push(0,0,1),g.push(T/o),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let S=0;S<o;S++){const T=S+c*p,M=S+c*(p+1),A=S+1+c*(p+1),E=S+1+c*p;f.push(T,M,E),f.push(M,A,E)}this.setIndex(f),this.setAttribute("position",new ti(m,3)),this.setAttribute("normal",new ti(x,3)),this.setAttribute("uv",new ti(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Va(t.width,t.height,t.widthSegments,t.heightSegments)}}function ds(i){const t={};for(const e in i){t[e]={};for(const n in i[e]){const s=i[e][n];if(Wh(s))s.isRenderTargetTexture?(Pt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Wh(s[0])){const r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function ke(i){const t={};for(let e=0;e<i.length;e++){const n=ds(i[e]);for(const s in n)t[s]=n[s]}return t}function Wh(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function v0(i){const t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function vf(i){const t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:qt.workingColorSpace}const _0={clone:ds,merge:ke};var x0=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,w0=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class Bi extends Ga{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=x0,this.fragmentShader=w0,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=ds(t.uniforms),this.uniformsGroups=v0(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){const e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(const s in this.uniforms){const a=this.uniforms[s].value;a&&a.isTexture?e.uniforms[s]={type:"t",value:a.toJSON(t).uuid}:a&&a.isColor?e.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?e.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?e.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?e.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?e.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?e.uniforms[s]={type:"m4",value:a.toArray()}:e.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;const n={};for(const s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(const n in t.uniforms){const s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new Gt().setHex(s.value);break;case"v2":this.uniforms[n].value=new Kt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new F().fromArray(s.value);break;case"v4":this.uniforms[n].value=new de().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Dt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Qt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(const n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}}class rs extends Bi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}}class S0 extends Ga{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Rm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}}class M0 extends Ga{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}}const Cr=new F,Lr=new gs,Sn=new F;class _f extends Ke{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Qt,this.projectionMatrix=new Qt,this.projectionMatrixInverse=new Qt,this.coordinateSystem=gn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Cr,Lr,Sn),Sn.x===1&&Sn.y===1&&Sn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Cr,Lr,Sn.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(Cr,Lr,Sn),Sn.x===1&&Sn.y===1&&Sn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Cr,Lr,Sn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}}const oi=new F,Xh=new Kt,qh=new Kt;class pn extends _f{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){const e=.5*this.getFilmHeight()/t;this.fov=Hl*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){const t=Math.tan(no*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Hl*2*Math.atan(Math.tan(no*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){oi.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(oi.x,oi.y).multiplyScalar(-t/oi.z),oi.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(oi.x,oi.y).multiplyScalar(-t/oi.z)}getViewSize(t,e){return this.getViewBounds(t,Xh,qh),e.subVectors(qh,Xh)}setViewOffset(t,e,n,s,r,a){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=this.near;let e=t*Math.tan(no*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s;const a=this.view;if(this.view!==null&&this.view.enabled){const l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,e-=a.offsetY*n/c,s*=a.width/l,n*=a.height/c}const o=this.filmOffset;o!==0&&(r+=t*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}}class y0 extends _f{constructor(t=-1,e=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=n-t,a=n+t,o=s+e,l=s-e;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}}const Qi=-90,ji=1;class Vl extends Ke{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new pn(Qi,ji,t,e);s.layers=this.layers,this.add(s);const r=new pn(Qi,ji,t,e);r.layers=this.layers,this.add(r);const a=new pn(Qi,ji,t,e);a.layers=this.layers,this.add(a);const o=new pn(Qi,ji,t,e);o.layers=this.layers,this.add(o);const l=new pn(Qi,ji,t,e);l.layers=this.layers,this.add(l);const c=new pn(Qi,ji,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const t=this.coordinateSystem,e=this.children.concat(),[n,s,r,a,o,l]=e;for(const c of e)this.remove(c);if(t===gn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Ma)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(const c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();const{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());const[r,a,o,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;const x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=x,t.setRenderTarget(n,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=m,n.texture.needsPMREMUpdate=!0}}class E0 extends pn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}}function $h(i,t,e,n){const s=b0(n);switch(e){case nf:return i*t;case rf:return i*t/s.components*s.byteLength;case Tc:return i*t/s.components*s.byteLength;case vi:return i*t*2/s.components*s.byteLength;case za:return i*t*2/s.components*s.byteLength;case sf:return i*t*3/s.components*s.byteLength;case an:return i*t*4/s.components*s.byteLength;case Ac:return i*t*4/s.components*s.byteLength;case na:case ia:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case sa:case ra:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case fl:case ml:return Math.max(i,16)*Math.max(t,8)/4;case dl:case pl:return Math.max(i,8)*Math.max(t,8)/2;case gl:case vl:case xl:case wl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case _l:case _a:case Sl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Ml:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case yl:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case El:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case bl:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case Tl:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Al:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Rl:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Cl:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Ll:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Pl:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Il:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Dl:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Nl:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Ul:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Fl:case Ol:case kl:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Bl:case zl:return Math.ceil(i/4)*Math.ceil(t/4)*8;case xa:case Gl:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function b0(i){switch(i){case sn:case Qd:return{byteLength:1,components:1};case er:case jd:case xn:return{byteLength:2,components:1};case Ec:case bc:return{byteLength:2,components:4};case ln:case yc:case rn:return{byteLength:4,components:1};case tf:case ef:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:Mc}}));typeof window<"u"&&(window.__THREE__?Pt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=Mc);/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function xf(){let i=null,t=!1,e=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),e(r,a)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function T0(i){const t=new WeakMap;function e(o,l){const c=o.array,h=o.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),o.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:u}}function n(o,l,c){const h=l.array,u=l.updateRanges;if(i.bindBuffer(c,o),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,m)=>f.start-m.start);let d=0;for(let f=1;f<u.length;f++){const m=u[d],x=u[f];x.start<=m.start+m.count+1?m.count=Math.max(m.count,x.start+x.count-m.start):(++d,u[d]=x)}u.length=d+1;for(let f=0,m=u.length;f<m;f++){const x=u[f];i.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),t.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);const l=t.get(o);l&&(i.deleteBuffer(l.buffer),t.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){const h=t.get(o);(!h||h.version<o.version)&&t.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}const c=t.get(o);if(c===void 0)t.set(o,e(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var A0=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,R0=`#ifdef USE_ALPHAHASH
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
#endif`,C0=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,L0=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,P0=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,I0=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,D0=`#ifdef USE_AOMAP
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
#endif`,N0=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,U0=`#ifdef USE_BATCHING
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
#endif`,F0=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,O0=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,k0=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,B0=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,z0=`#ifdef USE_IRIDESCENCE
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
#endif`,G0=`#ifdef USE_BUMPMAP
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
#endif`,H0=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,V0=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,W0=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,X0=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,q0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,$0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Y0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,K0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Z0=`#define PI 3.141592653589793
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
} // validated`,J0=`vec3 transformedNormal = objectNormal;
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
#endif`,Q0=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,j0=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,tg=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,eg=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,ng="gl_FragColor = linearToOutputTexel( gl_FragColor );",ig=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,sg=`#ifdef USE_ENVMAP
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
#endif`,rg=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,ag=`#ifdef USE_ENVMAP
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
#endif`,og=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,lg=`#ifdef USE_ENVMAP
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
#endif`,cg=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,hg=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ug=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,dg=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,fg=`#ifdef USE_GRADIENTMAP
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
}`,pg=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,mg=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,gg=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,vg=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,_g=`#ifdef USE_ENVMAP
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
#endif`,xg=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,wg=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Sg=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Mg=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,yg=`PhysicalMaterial material;
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
#endif`,Eg=`uniform sampler2D dfgLUT;
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
}`,bg=`
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
#endif`,Tg=`#if defined( RE_IndirectDiffuse )
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
#endif`,Ag=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Rg=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Cg=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Lg=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Pg=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ig=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Dg=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Ng=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Ug=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Fg=`#if defined( USE_POINTS_UV )
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
#endif`,Og=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,kg=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Bg=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,zg=`#if defined( USE_MORPHCOLORS )
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
#endif`,Gg=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Hg=`#ifdef USE_MORPHTARGETS
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
#endif`,Vg=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Wg=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Xg=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,qg=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,$g=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Yg=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Kg=`#ifdef USE_NORMALMAP
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
#endif`,Zg=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Jg=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Qg=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,jg=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,tv=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,ev=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,nv=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,iv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,sv=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,rv=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,av=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,ov=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,lv=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,cv=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,hv=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,uv=`float getShadowMask() {
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
}`,dv=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,fv=`#ifdef USE_SKINNING
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
#endif`,pv=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,mv=`#ifdef USE_SKINNING
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
#endif`,gv=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,vv=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,_v=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,xv=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,wv=`#ifdef USE_TRANSMISSION
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
#endif`,Sv=`#ifdef USE_TRANSMISSION
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
#endif`,Mv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,yv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Ev=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,bv=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const Tv=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Av=`uniform sampler2D t2D;
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
}`,Rv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Cv=`uniform float backgroundBlurriness;
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
}`,Lv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Pv=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Iv=`#include <common>
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
}`,Dv=`#if DEPTH_PACKING == 3200
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
}`,Nv=`#define DISTANCE
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
}`,Uv=`#define DISTANCE
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
}`,Fv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ov=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,kv=`uniform float scale;
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
}`,Bv=`uniform vec3 diffuse;
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
}`,zv=`#include <common>
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
}`,Gv=`uniform vec3 diffuse;
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
}`,Hv=`#define LAMBERT
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
}`,Vv=`#define LAMBERT
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
}`,Wv=`#define MATCAP
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
}`,Xv=`#define MATCAP
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
}`,qv=`#define NORMAL
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
}`,$v=`#define NORMAL
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
}`,Yv=`#define PHONG
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
}`,Kv=`#define PHONG
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
}`,Zv=`#define STANDARD
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
}`,Jv=`#define STANDARD
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
}`,Qv=`#define TOON
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
}`,jv=`#define TOON
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
}`,t_=`uniform float size;
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
}`,e_=`uniform vec3 diffuse;
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
}`,n_=`#include <common>
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
}`,i_=`uniform vec3 color;
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
}`,s_=`uniform float rotation;
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
}`,r_=`uniform vec3 diffuse;
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
}`,zt={alphahash_fragment:A0,alphahash_pars_fragment:R0,alphamap_fragment:C0,alphamap_pars_fragment:L0,alphatest_fragment:P0,alphatest_pars_fragment:I0,aomap_fragment:D0,aomap_pars_fragment:N0,batching_pars_vertex:U0,batching_vertex:F0,begin_vertex:O0,beginnormal_vertex:k0,bsdfs:B0,iridescence_fragment:z0,bumpmap_pars_fragment:G0,clipping_planes_fragment:H0,clipping_planes_pars_fragment:V0,clipping_planes_pars_vertex:W0,clipping_planes_vertex:X0,color_fragment:q0,color_pars_fragment:$0,color_pars_vertex:Y0,color_vertex:K0,common:Z0,defaultnormal_vertex:J0,displacementmap_pars_vertex:Q0,displacementmap_vertex:j0,emissivemap_fragment:tg,emissivemap_pars_fragment:eg,colorspace_fragment:ng,colorspace_pars_fragment:ig,envmap_fragment:sg,envmap_common_pars_fragment:rg,envmap_pars_fragment:ag,envmap_pars_vertex:og,envmap_physical_pars_fragment:_g,envmap_vertex:lg,fog_vertex:cg,fog_pars_vertex:hg,fog_fragment:ug,fog_pars_fragment:dg,gradientmap_pars_fragment:fg,lightmap_pars_fragment:pg,lights_lambert_fragment:mg,lights_lambert_pars_fragment:gg,lights_pars_begin:vg,lights_toon_fragment:xg,lights_toon_pars_fragment:wg,lights_phong_fragment:Sg,lights_phong_pars_fragment:Mg,lights_physical_fragment:yg,lights_physical_pars_fragment:Eg,lights_fragment_begin:bg,lights_fragment_maps:Tg,lights_fragment_end:Ag,lightprobes_pars_fragment:Rg,logdepthbuf_fragment:Cg,logdepthbuf_pars_fragment:Lg,logdepthbuf_pars_vertex:Pg,logdepthbuf_vertex:Ig,map_fragment:Dg,map_pars_fragment:Ng,map_particle_fragment:Ug,map_particle_pars_fragment:Fg,metalnessmap_fragment:Og,metalnessmap_pars_fragment:kg,morphinstance_vertex:Bg,morphcolor_vertex:zg,morphnormal_vertex:Gg,morphtarget_pars_vertex:Hg,morphtarget_vertex:Vg,normal_fragment_begin:Wg,normal_fragment_maps:Xg,normal_pars_fragment:qg,normal_pars_vertex:$g,normal_vertex:Yg,normalmap_pars_fragment:Kg,clearcoat_normal_fragment_begin:Zg,clearcoat_normal_fragment_maps:Jg,clearcoat_pars_fragment:Qg,iridescence_pars_fragment:jg,opaque_fragment:tv,packing:ev,premultiplied_alpha_fragment:nv,project_vertex:iv,dithering_fragment:sv,dithering_pars_fragment:rv,roughnessmap_fragment:av,roughnessmap_pars_fragment:ov,shadowmap_pars_fragment:lv,shadowmap_pars_vertex:cv,shadowmap_vertex:hv,shadowmask_pars_fragment:uv,skinbase_vertex:dv,skinning_pars_vertex:fv,skinning_vertex:pv,skinnormal_vertex:mv,specularmap_fragment:gv,specularmap_pars_fragment:vv,tonemapping_fragment:_v,tonemapping_pars_fragment:xv,transmission_fragment:wv,transmission_pars_fragment:Sv,uv_pars_fragment:Mv,uv_pars_vertex:yv,uv_vertex:Ev,worldpos_vertex:bv,background_vert:Tv,background_frag:Av,backgroundCube_vert:Rv,backgroundCube_frag:Cv,cube_vert:Lv,cube_frag:Pv,depth_vert:Iv,depth_frag:Dv,distance_vert:Nv,distance_frag:Uv,equirect_vert:Fv,equirect_frag:Ov,linedashed_vert:kv,linedashed_frag:Bv,meshbasic_vert:zv,meshbasic_frag:Gv,meshlambert_vert:Hv,meshlambert_frag:Vv,meshmatcap_vert:Wv,meshmatcap_frag:Xv,meshnormal_vert:qv,meshnormal_frag:$v,meshphong_vert:Yv,meshphong_frag:Kv,meshphysical_vert:Zv,meshphysical_frag:Jv,meshtoon_vert:Qv,meshtoon_frag:jv,points_vert:t_,points_frag:e_,shadow_vert:n_,shadow_frag:i_,sprite_vert:s_,sprite_frag:r_},ft={common:{diffuse:{value:new Gt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Dt},alphaMap:{value:null},alphaMapTransform:{value:new Dt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Dt}},envmap:{envMap:{value:null},envMapRotation:{value:new Dt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Dt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Dt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Dt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Dt},normalScale:{value:new Kt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Dt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Dt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Dt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Dt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Gt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Gt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Dt},alphaTest:{value:0},uvTransform:{value:new Dt}},sprite:{diffuse:{value:new Gt(16777215)},opacity:{value:1},center:{value:new Kt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Dt},alphaMap:{value:null},alphaMapTransform:{value:new Dt},alphaTest:{value:0}}},Rn={basic:{uniforms:ke([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.fog]),vertexShader:zt.meshbasic_vert,fragmentShader:zt.meshbasic_frag},lambert:{uniforms:ke([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Gt(0)},envMapIntensity:{value:1}}]),vertexShader:zt.meshlambert_vert,fragmentShader:zt.meshlambert_frag},phong:{uniforms:ke([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Gt(0)},specular:{value:new Gt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:zt.meshphong_vert,fragmentShader:zt.meshphong_frag},standard:{uniforms:ke([ft.common,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.roughnessmap,ft.metalnessmap,ft.fog,ft.lights,{emissive:{value:new Gt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:zt.meshphysical_vert,fragmentShader:zt.meshphysical_frag},toon:{uniforms:ke([ft.common,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.gradientmap,ft.fog,ft.lights,{emissive:{value:new Gt(0)}}]),vertexShader:zt.meshtoon_vert,fragmentShader:zt.meshtoon_frag},matcap:{uniforms:ke([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,{matcap:{value:null}}]),vertexShader:zt.meshmatcap_vert,fragmentShader:zt.meshmatcap_frag},points:{uniforms:ke([ft.points,ft.fog]),vertexShader:zt.points_vert,fragmentShader:zt.points_frag},dashed:{uniforms:ke([ft.common,ft.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:zt.linedashed_vert,fragmentShader:zt.linedashed_frag},depth:{uniforms:ke([ft.common,ft.displacementmap]),vertexShader:zt.depth_vert,fragmentShader:zt.depth_frag},normal:{uniforms:ke([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,{opacity:{value:1}}]),vertexShader:zt.meshnormal_vert,fragmentShader:zt.meshnormal_frag},sprite:{uniforms:ke([ft.sprite,ft.fog]),vertexShader:zt.sprite_vert,fragmentShader:zt.sprite_frag},background:{uniforms:{uvTransform:{value:new Dt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:zt.background_vert,fragmentShader:zt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Dt}},vertexShader:zt.backgroundCube_vert,fragmentShader:zt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:zt.cube_vert,fragmentShader:zt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:zt.equirect_vert,fragmentShader:zt.equirect_frag},distance:{uniforms:ke([ft.common,ft.displacementmap,{referencePosition:{value:new F},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:zt.distance_vert,fragmentShader:zt.distance_frag},shadow:{uniforms:ke([ft.lights,ft.fog,{color:{value:new Gt(0)},opacity:{value:1}}]),vertexShader:zt.shadow_vert,fragmentShader:zt.shadow_frag}};Rn.physical={uniforms:ke([Rn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Dt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Dt},clearcoatNormalScale:{value:new Kt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Dt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Dt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Dt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Dt},sheen:{value:0},sheenColor:{value:new Gt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Dt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Dt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Dt},transmissionSamplerSize:{value:new Kt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Dt},attenuationDistance:{value:0},attenuationColor:{value:new Gt(0)},specularColor:{value:new Gt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Dt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Dt},anisotropyVector:{value:new Kt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Dt}}]),vertexShader:zt.meshphysical_vert,fragmentShader:zt.meshphysical_frag};const Pr={r:0,b:0,g:0},a_=new Qt,wf=new Dt;wf.set(-1,0,0,0,1,0,0,0,1);function o_(i,t,e,n,s,r){const a=new Gt(0);let o=s===!0?0:1,l,c,h=null,u=0,d=null;function f(S){let T=S.isScene===!0?S.background:null;if(T&&T.isTexture){const M=S.backgroundBlurriness>0;T=t.get(T,M)}return T}function m(S){let T=!1;const M=f(S);M===null?g(a,o):M&&M.isColor&&(g(M,1),T=!0);const A=i.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||T)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(S,T){const M=f(T);M&&M.isCubeTexture?(c===void 0&&(c=new Nn(new rr(1,1,1),new Bi({name:"BackgroundCubeMaterial",uniforms:ds(Rn.backgroundCube.uniforms),vertexShader:Rn.backgroundCube.vertexShader,fragmentShader:Rn.backgroundCube.fragmentShader,side:Ve,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,E,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(a_.makeRotationFromEuler(T.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(wf),c.material.toneMapped=qt.getTransfer(M.colorSpace)!==ne,(h!==M||u!==M.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=M,u=M.version,d=i.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new Nn(new Va(2,2),new Bi({name:"BackgroundMaterial",uniforms:ds(Rn.background.uniforms),vertexShader:Rn.background.vertexShader,fragmentShader:Rn.background.fragmentShader,side:mi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=qt.getTransfer(M.colorSpace)!==ne,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||u!==M.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=M,u=M.version,d=i.toneMapping),l.layers.enableAll(),S.unshift(l,l.geometry,l.material,0,0,null))}function g(S,T){S.getRGB(Pr,vf(i)),e.buffers.color.setClear(Pr.r,Pr.g,Pr.b,T,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(S,T=1){a.set(S),o=T,g(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(S){o=S,g(a,o)},render:m,addToRenderList:x,dispose:p}}function l_(i,t){const e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null);let r=s,a=!1;function o(D,B,W,C,H){let Z=!1;const G=u(D,C,W,B);r!==G&&(r=G,c(r.object)),Z=f(D,C,W,H),Z&&m(D,C,W,H),H!==null&&t.update(H,i.ELEMENT_ARRAY_BUFFER),(Z||a)&&(a=!1,M(D,B,W,C),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(H).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function u(D,B,W,C){const H=C.wireframe===!0;let Z=n[B.id];Z===void 0&&(Z={},n[B.id]=Z);const G=D.isInstancedMesh===!0?D.id:0;let et=Z[G];et===void 0&&(et={},Z[G]=et);let X=et[W.id];X===void 0&&(X={},et[W.id]=X);let Q=X[H];return Q===void 0&&(Q=d(l()),X[H]=Q),Q}function d(D){const B=[],W=[],C=[];for(let H=0;H<e;H++)B[H]=0,W[H]=0,C[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:W,attributeDivisors:C,object:D,attributes:{},index:null}}function f(D,B,W,C){const H=r.attributes,Z=B.attributes;let G=0;const et=W.getAttributes();for(const X in et)if(et[X].location>=0){const j=H[X];let Mt=Z[X];if(Mt===void 0&&(X==="instanceMatrix"&&D.instanceMatrix&&(Mt=D.instanceMatrix),X==="instanceColor"&&D.instanceColor&&(Mt=D.instanceColor)),j===void 0||j.attribute!==Mt||Mt&&j.data!==Mt.data)return!0;G++}return r.attributesNum!==G||r.index!==C}function m(D,B,W,C){const H={},Z=B.attributes;let G=0;const et=W.getAttributes();for(const X in et)if(et[X].location>=0){let j=Z[X];j===void 0&&(X==="instanceMatrix"&&D.instanceMatrix&&(j=D.instanceMatrix),X==="instanceColor"&&D.instanceColor&&(j=D.instanceColor));const Mt={};Mt.attribute=j,j&&j.data&&(Mt.data=j.data),H[X]=Mt,G++}r.attributes=H,r.attributesNum=G,r.index=C}function x(){const D=r.newAttributes;for(let B=0,W=D.length;B<W;B++)D[B]=0}function g(D){p(D,0)}function p(D,B){const W=r.newAttributes,C=r.enabledAttributes,H=r.attributeDivisors;W[D]=1,C[D]===0&&(i.enableVertexAttribArray(D),C[D]=1),H[D]!==B&&(i.vertexAttribDivisor(D,B),H[D]=B)}function S(){const D=r.newAttributes,B=r.enabledAttributes;for(let W=0,C=B.length;W<C;W++)B[W]!==D[W]&&(i.disableVertexAttribArray(W),B[W]=0)}function T(D,B,W,C,H,Z,G){G===!0?i.vertexAttribIPointer(D,B,W,H,Z):i.vertexAttribPointer(D,B,W,C,H,Z)}function M(D,B,W,C){x();const H=C.attributes,Z=W.getAttributes(),G=B.defaultAttributeValues;for(const et in Z){const X=Z[et];if(X.location>=0){let Q=H[et];if(Q===void 0&&(et==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),et==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){const j=Q.normalized,Mt=Q.itemSize,Nt=t.get(Q);if(Nt===void 0)continue;const Y=Nt.buffer,pt=Nt.type,xt=Nt.bytesPerElement,Rt=pt===i.INT||pt===i.UNSIGNED_INT||Q.gpuType===yc;if(Q.isInterleavedBufferAttribute){const gt=Q.data,Ft=gt.isInterleavedBuffer===!0?gt.stride:gt.itemSize,pe=Q.offset;if(gt.isInstancedInterleavedBuffer||gt.isInstancedBufferAttribute){for(let Lt=0;Lt<X.locationSize;Lt++)p(X.location+Lt,gt.meshPerAttribute);D.isInstancedMesh!==!0&&C._maxInstanceCount===void 0&&(C._maxInstanceCount=gt.meshPerAttribute*gt.count)}else for(let Lt=0;Lt<X.locationSize;Lt++)g(X.location+Lt);i.bindBuffer(i.ARRAY_BUFFER,Y);for(let Lt=0;Lt<X.locationSize;Lt++)T(X.location+Lt,Mt/X.locationSize,pt,j,Ft*xt,(pe+Mt/X.locationSize*Lt)*xt,Rt)}else{if(Q.isInstancedBufferAttribute){for(let gt=0;gt<X.locationSize;gt++)p(X.location+gt,Q.meshPerAttribute);D.isInstancedMesh!==!0&&C._maxInstanceCount===void 0&&(C._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let gt=0;gt<X.locationSize;gt++)g(X.location+gt);i.bindBuffer(i.ARRAY_BUFFER,Y);for(let gt=0;gt<X.locationSize;gt++)T(X.location+gt,Mt/X.locationSize,pt,j,Mt*xt,Mt/X.locationSize*gt*xt,Rt)}}else if(G!==void 0){const j=G[et];if(j!==void 0)switch(j.length){case 2:i.vertexAttrib2fv(X.location,j);break;case 3:i.vertexAttrib3fv(X.location,j);break;case 4:i.vertexAttrib4fv(X.location,j);break;default:i.vertexAttrib1fv(X.location,j)}}}}S()}function A(){N();for(const D in n){const B=n[D];for(const W in B){const C=B[W];for(const H in C){const Z=C[H];for(const G in Z)h(Z[G].object),delete Z[G];delete C[H]}}delete n[D]}}function E(D){if(n[D.id]===void 0)return;const B=n[D.id];for(const W in B){const C=B[W];for(const H in C){const Z=C[H];for(const G in Z)h(Z[G].object),delete Z[G];delete C[H]}}delete n[D.id]}function v(D){for(const B in n){const W=n[B];for(const C in W){const H=W[C];if(H[D.id]===void 0)continue;const Z=H[D.id];for(const G in Z)h(Z[G].object),delete Z[G];delete H[D.id]}}}function y(D){for(const B in n){const W=n[B],C=D.isInstancedMesh===!0?D.id:0,H=W[C];if(H!==void 0){for(const Z in H){const G=H[Z];for(const et in G)h(G[et].object),delete G[et];delete H[Z]}delete W[C],Object.keys(W).length===0&&delete n[B]}}}function N(){P(),a=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:N,resetDefaultState:P,dispose:A,releaseStatesOfGeometry:E,releaseStatesOfObject:y,releaseStatesOfProgram:v,initAttributes:x,enableAttribute:g,disableUnusedAttributes:S}}function c_(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function a(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function o(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function h_(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){const v=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(v){return!(v!==an&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(v){const y=v===xn&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(v!==sn&&v!==rn&&!y&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp";const h=l(c);h!==c&&(Pt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);const u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&Pt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&Pt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");const f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),S=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),A=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:m,maxTextureSize:x,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:S,maxVaryings:T,maxFragmentUniforms:M,maxSamples:A,samples:E}}function u_(i){const t=this;let e=null,n=0,s=!1,r=!1;const a=new ci,o=new Dt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){const f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){const m=u.clippingPlanes,x=u.clipIntersection,g=u.clipShadows,p=i.get(u);if(!s||m===null||m.length===0||r&&!g)r?h(null):c();else{const S=r?0:n,T=S*4;let M=p.clippingState||null;l.value=M,M=h(m,d,T,f);for(let A=0;A!==T;++A)M[A]=e[A];p.clippingState=M,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=S}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,d,f,m){const x=u!==null?u.length:0;let g=null;if(x!==0){if(g=l.value,m!==!0||g===null){const p=f+x*4,S=d.matrixWorldInverse;o.getNormalMatrix(S),(g===null||g.length<p)&&(g=new Float32Array(p));for(let T=0,M=f;T!==x;++T,M+=4)a.copy(u[T]).applyMatrix4(S,o),a.normal.toArray(g,M),g[M+3]=a.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,g}}class Nc extends _n{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;const n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new pf(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;const n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new rr(5,5,5),r=new Bi({name:"CubemapFromEquirect",uniforms:ds(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Ve,blending:os});r.uniforms.tEquirect.value=e;const a=new Nn(s,r),o=e.minFilter;return e.minFilter===ui&&(e.minFilter=Fe),new Vl(1,10,this).update(t,a),e.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){const r=t.getRenderTarget();for(let a=0;a<6;a++)t.setRenderTarget(this,a),t.clear(e,n,s);t.setRenderTarget(r)}}const Yh=256,d_=3,f_=20,Sf=256,Mf=16,p_=3,m_=new F,g_=new Gt;class ba{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Vl(1,10,null),this._boxMesh=new Nn(new rr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){const{size:a=256,position:o=m_}=r,l=this._renderer;this._setSize(a);const c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);const u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(g_));const g=new Vl(n,s,h);return g.position.copy(o),g.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=m,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Jh(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Zh(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Yh,Hm(t))}_fromTexture(t,e){t.mapping===hs||t.mapping===tr?this._setSize(t.image.length===0?Yh:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);const n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){const t=this._cubeSize,e=Kh(t,!1,!1),n=Math.log2(t)-d_;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){const e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Kh(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){const s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;const a=t.width>>e;t.viewport.set(0,0,a,a),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===hs||t.mapping===tr?(this._cubemapMaterial===null&&(this._cubemapMaterial=Jh()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Zh()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=v_(),this._integrationMaterial=__());const e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;const r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Mf);for(let a=0;a<=n;a++){const o=ba.lodToRoughness(a,n);if(a>n-p_)r.roughness.value=o,this._renderCube(t,a,this._integrationMaterial);else{const l=o>0?Math.log2(e)+.5*Math.log2(6/(Sf*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(t,a,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=x_());const n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}}function Kh(i,t,e){return new Nc(i,{minFilter:ui,generateMipmaps:t,type:xn,colorSpace:wa,depthBuffer:e})}function ar(i,t,e){return new Bi({name:i,uniforms:t,vertexShader:zt.cube_vert,fragmentShader:e,side:Ve,blending:os,depthTest:!1,depthWrite:!1})}function v_(){return ar("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Sf}u

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
	`)}function __(){return ar("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Mf}},`

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
	`)}function x_(){return ar("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${f_}
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
	`)}function Zh(){return ar("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Jh(){return ar("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function w_(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?a(d):r(d)}function r(d){if(d&&d.isTexture){const f=d.mapping;if(f===Qa||f===ja)if(t.has(d)){const m=t.get(d).texture;return o(m,d.mapping)}else{const m=d.image;if(m&&m.height>0){const x=new Nc(m.height);return x.fromEquirectangularTexture(i,d),t.set(d,x),d.addEventListener("dispose",c),o(x.texture,d.mapping)}else return null}}return d}function a(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){const f=d.mapping,m=f===Qa||f===ja,x=f===hs||f===tr;if(m||x){let g=e.get(d);const p=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==p)return n===null&&(n=new ba(i)),g=m?n.fromEquirectangular(d,g):n.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),g.texture;if(g!==void 0)return g.texture;{const S=d.image;return m&&S&&S.height>0||x&&S&&l(S)?(n===null&&(n=new ba(i)),g=m?n.fromEquirectangular(d):n.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),d.addEventListener("dispose",h),g.texture):null}}}return d}function o(d,f){return f===Qa?d.mapping=hs:f===ja&&(d.mapping=tr),d}function l(d){let f=0;const m=6;for(let x=0;x<m;x++)d[x]!==void 0&&f++;return f===m}function c(d){const f=d.target;f.removeEventListener("dispose",c);const m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function h(d){const f=d.target;f.removeEventListener("dispose",h);const m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function S_(i){const t={};function e(n){if(t[n]!==void 0)return t[n];const s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){const s=e(n);return s===null&&aa("WebGLRenderer: "+n+" extension not supported."),s}}}function M_(i,t,e,n){const s={},r=new WeakMap,a=new FinalizationRegistry(m=>delete s[m]);function o(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(const g in m.attributes)t.remove(m.attributes[g]);m.removeEventListener("dispose",o),delete s[m.id],a.unregister(m);const x=r.get(m);x&&(t.remove(x),r.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,x){return s[x.id]!==void 0||(x.addEventListener("dispose",o),s[x.id]=new WeakRef(x),a.register(x,x.id,x),e.memory.geometries++),x}function h(m){const x=m.attributes;for(const g in x)t.update(x[g],i.ARRAY_BUFFER)}function u(m){const x=m.index,g=m.attributes.position;let p=0;if(g===void 0)return;const S=x!==null?x.array.length:g.array.length/3-1,T=g.count>=65535?ff:df,M=new T(Math.ceil(S/3)*6,1),A=M.array;if(x!==null){const v=x.array;p=x.version;for(let y=0,N=0;y<S;y+=3){const P=v[y+0],D=v[y+1],B=v[y+2];A[N++]=P,A[N++]=D,A[N++]=D,A[N++]=B,A[N++]=B,A[N++]=P}}else{p=g.version;for(let v=0,y=0;v<S;v+=3){const N=v+0,P=v+1,D=v+2;A[y++]=N,A[y++]=P,A[y++]=P,A[y++]=D,A[y++]=D,A[y++]=N}}M.version=p;const E=r.get(m);E&&t.remove(E),r.set(m,M)}function d(m){const x=r.get(m);if(x){const g=m.index;g!==null&&x.version<g.version&&u(m)}else u(m);return r.get(m)}function f(){for(const m in s){const x=s[m].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function y_(i,t,e){let n;function s(u){n=u}let r,a;function o(u){r=u.type,a=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*a),e.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*a,f),e.update(d,n,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let x=0;for(let g=0;g<f;g++)x+=d[g];e.update(x,n,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function E_(i){const t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(e.calls++,a){case i.TRIANGLES:e.triangles+=o*(r/3);break;case i.LINES:e.lines+=o*(r/2);break;case i.LINE_STRIP:e.lines+=o*(r-1);break;case i.LINE_LOOP:e.lines+=o*r;break;case i.POINTS:e.points+=o*r;break;default:Jt("WebGLInfo: Unknown draw mode:",a);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function b_(i,t,e){const n=new WeakMap,s=new de;function r(a,o,l){const c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,u=h!==void 0?h.length:0;let d=n.get(o);if(d===void 0||d.count!==u){let N=function(){v.dispose(),n.delete(o),o.removeEventListener("dispose",N)};d!==void 0&&d.texture.dispose();const f=o.morphAttributes.position!==void 0,m=o.morphAttributes.normal!==void 0,x=o.morphAttributes.color!==void 0,g=o.morphAttributes.position||[],p=o.morphAttributes.normal||[],S=o.morphAttributes.color||[];let T=0;f===!0&&(T=1),m===!0&&(T=2),x===!0&&(T=3);let M=o.attributes.position.count*T,A=1;M>t.maxTextureSize&&(A=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);const E=new Float32Array(M*A*4*u),v=new Pc(E,M,A,u);v.type=rn,v.needsUpdate=!0;const y=T*4;for(let P=0;P<u;P++){const D=g[P],B=p[P],W=S[P],C=M*A*4*P;for(let H=0;H<D.count;H++){const Z=H*y;f===!0&&(s.fromBufferAttribute(D,H),E[C+Z+0]=s.x,E[C+Z+1]=s.y,E[C+Z+2]=s.z,E[C+Z+3]=0),m===!0&&(s.fromBufferAttribute(B,H),E[C+Z+4]=s.x,E[C+Z+5]=s.y,E[C+Z+6]=s.z,E[C+Z+7]=0),x===!0&&(s.fromBufferAttribute(W,H),E[C+Z+8]=s.x,E[C+Z+9]=s.y,E[C+Z+10]=s.z,E[C+Z+11]=W.itemSize===4?s.w:1)}}d={count:u,texture:v,size:new Kt(M,A)},n.set(o,d),o.addEventListener("dispose",N)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",a.morphTexture,e);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];const m=o.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function T_(i,t,e,n,s){let r=new WeakMap;function a(c){const h=s.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){const f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function o(){r=new WeakMap}function l(c){const h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:a,dispose:o}}const A_={[Wd]:"LINEAR_TONE_MAPPING",[Xd]:"REINHARD_TONE_MAPPING",[qd]:"CINEON_TONE_MAPPING",[$d]:"ACES_FILMIC_TONE_MAPPING",[Kd]:"AGX_TONE_MAPPING",[Zd]:"NEUTRAL_TONE_MAPPING",[Yd]:"CUSTOM_TONE_MAPPING"};function R_(i,t,e,n,s,r){const a=new _n(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1});let o=null,l=null,c=null;const h=new Fn;h.setAttribute("position",new ti([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new ti([0,2,0,0,2,0],2));const u=new rs({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Nn(h,u),f=new y0(-1,1,1,-1,0,1);let m=null,x=null,g=!1,p,S=null,T=[],M=!1;this.setSize=function(A,E){a.setSize(A,E),o!==null&&o.setSize(A,E),l!==null&&l.setSize(A,E);for(let v=0;v<T.length;v++){const y=T[v];y.setSize&&y.setSize(A,E)}},this.setEffects=function(A){T=A,M=T.length>0&&T[0].isRenderPass===!0;const E=a.width,v=a.height;T.length>0&&o===null&&(o=new _n(E,v,{type:xn,depthBuffer:!1,stencilBuffer:!1}),l=new _n(E,v,{type:xn,depthBuffer:!1,stencilBuffer:!1}));const y=s===!0&&T.some(N=>N.needsDepthTexture===!0);y!==(a.depthTexture!==null)&&(y===!0&&c===null&&(c=new ki(E,v),r===!0&&(c.format=di,c.type=us)),a.dispose(),a.depthTexture=y?c:null,a.resolveDepthBuffer=y,a.storeMultisampledDepthBuffer=y);for(let N=0;N<T.length;N++){const P=T[N];P.setSize&&P.setSize(E,v),y&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(A,E){if(g||A.toneMapping===Qn&&T.length===0)return!1;if(S=E,E!==null){const v=E.width,y=E.height;(a.width!==v||a.height!==y)&&this.setSize(v,y)}return M===!1&&A.setRenderTarget(a),p=A.toneMapping,A.toneMapping=Qn,!0},this.hasRenderPass=function(){return M},this.end=function(A,E){A.toneMapping=p,g=!0;let v=a,y=o;for(let N=0;N<T.length;N++){const P=T[N];P.enabled!==!1&&(P.render(A,y,v,E),P.needsSwap!==!1&&(v=y,y=y===o?l:o))}if(m!==A.outputColorSpace||x!==A.toneMapping){m=A.outputColorSpace,x=A.toneMapping,u.defines={},qt.getTransfer(m)===ne&&(u.defines.SRGB_TRANSFER="");const N=A_[x];N&&(u.defines[N]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=v.texture,A.setRenderTarget(S),A.render(d,f),S=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}const yf=new Be,Ef=new ki(1,1),bf=new mf(1),Tf=new Pc,Af=new Zm,Rf=new pf,Qh=[],jh=[],tu=new Float32Array(16),eu=new Float32Array(9),nu=new Float32Array(4);function vs(i,t,e){const n=i[0];if(n<=0||n>0)return i;const s=t*e;let r=Qh[s];if(r===void 0&&(r=new Float32Array(s),Qh[s]=r),t!==0){n.toArray(r,0);for(let a=1,o=0;a!==t;++a)o+=e,i[a].toArray(r,o)}return r}function Me(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function ye(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Wa(i,t){let e=jh[t];e===void 0&&(e=new Int32Array(t),jh[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function C_(i,t){const e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function L_(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Me(e,t))return;i.uniform2fv(this.addr,t),ye(e,t)}}function P_(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Me(e,t))return;i.uniform3fv(this.addr,t),ye(e,t)}}function I_(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Me(e,t))return;i.uniform4fv(this.addr,t),ye(e,t)}}function D_(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(Me(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),ye(e,t)}else{if(Me(e,n))return;nu.set(n),i.uniformMatrix2fv(this.addr,!1,nu),ye(e,n)}}function N_(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(Me(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),ye(e,t)}else{if(Me(e,n))return;eu.set(n),i.uniformMatrix3fv(this.addr,!1,eu),ye(e,n)}}function U_(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(Me(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),ye(e,t)}else{if(Me(e,n))return;tu.set(n),i.uniformMatrix4fv(this.addr,!1,tu),ye(e,n)}}function F_(i,t){const e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function O_(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Me(e,t))return;i.uniform2iv(this.addr,t),ye(e,t)}}function k_(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Me(e,t))return;i.uniform3iv(this.addr,t),ye(e,t)}}function B_(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Me(e,t))return;i.uniform4iv(this.addr,t),ye(e,t)}}function z_(i,t){const e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function G_(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Me(e,t))return;i.uniform2uiv(this.addr,t),ye(e,t)}}function H_(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Me(e,t))return;i.uniform3uiv(this.addr,t),ye(e,t)}}function V_(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Me(e,t))return;i.uniform4uiv(this.addr,t),ye(e,t)}}function Xa(i){return i.version===0&&(i.compareFunction=of,i.needsUpdate=!0),i}function W_(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Xa(Ef):r=yf,e.setTexture2D(t||r,s)}function X_(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Af,s)}function q_(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Xa(bf):r=Rf,e.setTextureCube(t||r,s)}function $_(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Tf,s)}function Y_(i){switch(i){case 5126:return C_;case 35664:return L_;case 35665:return P_;case 35666:return I_;case 35674:return D_;case 35675:return N_;case 35676:return U_;case 5124:case 35670:return F_;case 35667:case 35671:return O_;case 35668:case 35672:return k_;case 35669:case 35673:return B_;case 5125:return z_;case 36294:return G_;case 36295:return H_;case 36296:return V_;case 35678:case 36198:case 36298:case 36306:case 35682:return W_;case 35679:case 36299:case 36307:return X_;case 35680:case 36300:case 36308:case 36293:return q_;case 36289:case 36303:case 36311:case 36292:return $_}}function K_(i,t){i.uniform1fv(this.addr,t)}function Z_(i,t){const e=vs(t,this.size,2);i.uniform2fv(this.addr,e)}function J_(i,t){const e=vs(t,this.size,3);i.uniform3fv(this.addr,e)}function Q_(i,t){const e=vs(t,this.size,4);i.uniform4fv(this.addr,e)}function j_(i,t){const e=vs(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function tx(i,t){const e=vs(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function ex(i,t){const e=vs(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function nx(i,t){i.uniform1iv(this.addr,t)}function ix(i,t){i.uniform2iv(this.addr,t)}function sx(i,t){i.uniform3iv(this.addr,t)}function rx(i,t){i.uniform4iv(this.addr,t)}function ax(i,t){i.uniform1uiv(this.addr,t)}function ox(i,t){i.uniform2uiv(this.addr,t)}function lx(i,t){i.uniform3uiv(this.addr,t)}function cx(i,t){i.uniform4uiv(this.addr,t)}function hx(i,t,e){const n=this.cache,s=t.length,r=Wa(e,s);Me(n,r)||(i.uniform1iv(this.addr,r),ye(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=Xa(Ef):a=yf;for(let o=0;o!==s;++o)e.setTexture2D(t[o]||a,r[o])}function ux(i,t,e){const n=this.cache,s=t.length,r=Wa(e,s);Me(n,r)||(i.uniform1iv(this.addr,r),ye(n,r));for(let a=0;a!==s;++a)e.setTexture3D(t[a]||Af,r[a])}function dx(i,t,e){const n=this.cache,s=t.length,r=Wa(e,s);Me(n,r)||(i.uniform1iv(this.addr,r),ye(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Xa(bf):a=Rf;for(let o=0;o!==s;++o)e.setTextureCube(t[o]||a,r[o])}function fx(i,t,e){const n=this.cache,s=t.length,r=Wa(e,s);Me(n,r)||(i.uniform1iv(this.addr,r),ye(n,r));for(let a=0;a!==s;++a)e.setTexture2DArray(t[a]||Tf,r[a])}function px(i){switch(i){case 5126:return K_;case 35664:return Z_;case 35665:return J_;case 35666:return Q_;case 35674:return j_;case 35675:return tx;case 35676:return ex;case 5124:case 35670:return nx;case 35667:case 35671:return ix;case 35668:case 35672:return sx;case 35669:case 35673:return rx;case 5125:return ax;case 36294:return ox;case 36295:return lx;case 36296:return cx;case 35678:case 36198:case 36298:case 36306:case 35682:return hx;case 35679:case 36299:case 36307:return ux;case 35680:case 36300:case 36308:case 36293:return dx;case 36289:case 36303:case 36311:case 36292:return fx}}class mx{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Y_(e.type)}}class gx{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=px(e.type)}}class vx{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){const s=this.seq;for(let r=0,a=s.length;r!==a;++r){const o=s[r];o.setValue(t,e[o.id],n)}}}const bo=/(\w+)(\])?(\[|\.)?/g;function iu(i,t){i.seq.push(t),i.map[t.id]=t}function _x(i,t,e){const n=i.name,s=n.length;for(bo.lastIndex=0;;){const r=bo.exec(n),a=bo.lastIndex;let o=r[1];const l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){iu(e,c===void 0?new mx(o,i,t):new gx(o,i,t));break}else{let u=e.map[o];u===void 0&&(u=new vx(o),iu(e,u)),e=u}}}class oa{constructor(t,e){this.seq=[],this.map={};const n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){const o=t.getActiveUniform(e,a),l=t.getUniformLocation(e,o.name);_x(o,l,this)}const s=[],r=[];for(const a of this.seq)a.type===t.SAMPLER_2D_SHADOW||a.type===t.SAMPLER_CUBE_SHADOW||a.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){const r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){const s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,a=e.length;r!==a;++r){const o=e[r],l=n[o.id];l.needsUpdate!==!1&&o.setValue(t,l.value,s)}}static seqWithValue(t,e){const n=[];for(let s=0,r=t.length;s!==r;++s){const a=t[s];a.id in e&&n.push(a)}return n}}function su(i,t,e){const n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}const xx=37297;let wx=0;function Sx(i,t){const e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let a=s;a<r;a++){const o=a+1;n.push(`${o===t?">":" "} ${o}: ${e[a]}`)}return n.join(`
`)}const ru=new Dt;function Mx(i){qt._getMatrix(ru,qt.workingColorSpace,i);const t=`mat3( ${ru.elements.map(e=>e.toFixed(4))} )`;switch(qt.getTransfer(i)){case Sa:return[t,"LinearTransferOETF"];case ne:return[t,"sRGBTransferOETF"];default:return Pt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function au(i,t,e){const n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";const a=/ERROR: 0:(\d+)/.exec(r);if(a){const o=parseInt(a[1]);return e.toUpperCase()+`

`+r+`

`+Sx(i.getShaderSource(t),o)}else return r}function yx(i,t){const e=Mx(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}const Ex={[Wd]:"Linear",[Xd]:"Reinhard",[qd]:"Cineon",[$d]:"ACESFilmic",[Kd]:"AgX",[Zd]:"Neutral",[Yd]:"Custom"};function bx(i,t){const e=Ex[t];return e===void 0?(Pt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}const Ir=new F;function Tx(){qt.getLuminanceCoefficients(Ir);const i=Ir.x.toFixed(4),t=Ir.y.toFixed(4),e=Ir.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Ax(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Hs).join(`
`)}function Rx(i){const t=[];for(const e in i){const n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function Cx(i,t){const e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){const r=i.getActiveAttrib(t,s),a=r.name;let o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),e[a]={type:r.type,location:i.getAttribLocation(t,a),locationSize:o}}return e}function Hs(i){return i!==""}function ou(i,t){const e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function lu(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}const Lx=/^[ \t]*#include +<([\w\d./]+)>/gm;function Wl(i){return i.replace(Lx,Px)}function Px(i,t){const e=zt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Wl(e)}const Ix=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function cu(i){return i.replace(Ix,Dx)}function Dx(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function hu(i){let t=`precision ${i.precision} float;
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
#define LOW_PRECISION`),t}const Nx={[ea]:"SHADOWMAP_TYPE_PCF",[Gs]:"SHADOWMAP_TYPE_VSM"};function Ux(i){return Nx[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}const Fx={[tr]:"ENVMAP_MODE_REFRACTION"};function Ox(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Fx[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}const kx={[Vd]:"ENVMAP_BLENDING_MULTIPLY",[bm]:"ENVMAP_BLENDING_MIX",[Tm]:"ENVMAP_BLENDING_ADD"};function Bx(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":kx[i.combine]||"ENVMAP_BLENDING_NONE"}function zx(i,t,e,n){const s=i.getContext(),r=e.defines;let a=e.vertexShader,o=e.fragmentShader;const l=Ux(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Ox(e),u=Bx(e),d=Ax(e),f=Rx(r),m=s.createProgram();let x,g,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Hs).join(`
`),x.length>0&&(x+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Hs).join(`
`),g.length>0&&(g+=`
`)):(x=[hu(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Hs).join(`
`),g=[hu(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Qn?"#define TONE_MAPPING":"",e.toneMapping!==Qn?zt.tonemapping_pars_fragment:"",e.toneMapping!==Qn?bx("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",zt.colorspace_pars_fragment,yx("linearToOutputTexel",e.outputColorSpace),Tx(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Hs).join(`
`)),a=Wl(a),a=ou(a,e),a=lu(a,e),o=Wl(o),o=ou(o,e),o=lu(o,e),a=cu(a),o=cu(o),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,g=["#define varying in",e.glslVersion===Li?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Li?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);const S=p+x+a,T=p+g+o,M=su(s,s.VERTEX_SHADER,S),A=su(s,s.FRAGMENT_SHADER,T);s.attachShader(m,M),s.attachShader(m,A),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function E(P){if(i.debug.checkShaderErrors){const D=s.getProgramInfoLog(m)||"",B=s.getShaderInfoLog(M)||"",W=s.getShaderInfoLog(A)||"",C=D.trim(),H=B.trim(),Z=W.trim();let G=!0,et=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(G=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,m,M,A);else{const X=au(s,M,"vertex"),Q=au(s,A,"fragment");Jt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+C+`
`+X+`
`+Q)}else C!==""?Pt("WebGLProgram: Program Info Log:",C):(H===""||Z==="")&&(et=!1);et&&(P.diagnostics={runnable:G,programLog:C,vertexShader:{log:H,prefix:x},fragmentShader:{log:Z,prefix:g}})}s.deleteShader(M),s.deleteShader(A),v=new oa(s,m),y=Cx(s,m)}let v;this.getUniforms=function(){return v===void 0&&E(this),v};let y;this.getAttributes=function(){return y===void 0&&E(this),y};let N=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(m,xx)),N},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=wx++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=M,this.fragmentShader=A,this}let Gx=0;class Hx{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){const s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){const e=this.materialCache.get(t);for(const n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){const e=this.materialCache;let n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){const e=this.shaderCache;let n=e.get(t);return n===void 0&&(n=new Vx(t),e.set(t,n)),n}}class Vx{constructor(t){this.id=Gx++,this.code=t,this.usedTimes=0}}function Wx(i){return i===vi||i===_a||i===xa}function Xx(i,t,e,n,s,r){const a=new cf,o=new Hx,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(v){return l.add(v),v===0?"uv":`uv${v}`}function m(v,y,N,P,D,B){const W=P.fog,C=D.geometry,H=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?P.environment:null,Z=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,G=t.get(v.envMap||H,Z),et=d[v.type];let X=n.precision;v.precision!==null&&(X=n.getMaxPrecision(v.precision),X!==v.precision&&Pt("WebGLProgram.getParameters:",v.precision,"not supported, using",X,"instead."));const Q=C.morphAttributes.position||C.morphAttributes.normal||C.morphAttributes.color,j=Q!==void 0?Q.length:0;let Mt=0;C.morphAttributes.position!==void 0&&(Mt=1),C.morphAttributes.normal!==void 0&&(Mt=2),C.morphAttributes.color!==void 0&&(Mt=3);let Nt,Y,pt,xt;if(et){const dt=Rn[et];Nt=dt.vertexShader,Y=dt.fragmentShader}else{Nt=v.vertexShader,Y=v.fragmentShader;const dt=o.getVertexShaderStage(v),ee=o.getFragmentShaderStage(v);o.update(v,dt,ee),pt=dt.id,xt=ee.id}const Rt=i.getRenderTarget(),gt=i.state.buffers.depth.getReversed(),Ft=D.isInstancedMesh===!0,pe=D.isBatchedMesh===!0,Lt=!!v.map,te=!!v.matcap,ie=!!G,Ht=ie&&G.isPMREMTexture===!0,Ce=!!v.aoMap,we=!!v.lightMap,Ge=!!v.bumpMap&&v.wireframe===!1,he=!!v.normalMap,wn=!!v.displacementMap,Ee=!!v.emissiveMap,Ze=!!v.metalnessMap,Je=!!v.roughnessMap,Qe=v.anisotropy>0,I=v.clearcoat>0,je=v.diffuseRoughness>0,le=v.dispersion>0,ce=v.retroreflectivity>0,ut=v.iridescence>0,Se=v.sheen>0,Ct=v.transmission>0,It=Qe&&!!v.anisotropyMap,b=I&&!!v.clearcoatMap,_=I&&!!v.clearcoatNormalMap,O=I&&!!v.clearcoatRoughnessMap,tt=je&&!!v.diffuseRoughnessMap,J=ut&&!!v.iridescenceMap,st=ut&&!!v.iridescenceThicknessMap,ct=Se&&!!v.sheenColorMap,q=Se&&!!v.sheenRoughnessMap,$=!!v.specularMap,at=!!v.specularColorMap,R=!!v.specularIntensityMap,K=Ct&&!!v.transmissionMap,V=Ct&&!!v.thicknessMap,ot=!!v.gradientMap,it=!!v.alphaMap,rt=v.alphaTest>0,Et=!!v.alphaHash,Bt=!!v.extensions;let nt=Qn;v.toneMapped&&(Rt===null||Rt.isXRRenderTarget===!0)&&(nt=i.toneMapping);const Tt=Ht?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Ot={shaderID:et,shaderType:v.type,shaderName:v.name,vertexShader:Nt,fragmentShader:Y,defines:v.defines,customVertexShaderID:pt,customFragmentShaderID:xt,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:X,batching:pe,batchingColor:pe&&D._colorsTexture!==null,instancing:Ft,instancingColor:Ft&&D.instanceColor!==null,instancingMorph:Ft&&D.morphTexture!==null,outputColorSpace:Rt===null?i.outputColorSpace:Rt.isXRRenderTarget===!0?Rt.texture.colorSpace:qt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Lt,matcap:te,envMap:ie,envMapMode:ie&&G.mapping,envMapPMREM:Ht,envMapMaxLod:Ht?Tt.length-1:null,envMapSize:Ht?Tt[0].width:null,aoMap:Ce,lightMap:we,bumpMap:Ge,normalMap:he,displacementMap:wn,emissiveMap:Ee,normalMapObjectSpace:he&&v.normalMapType===Cm,normalMapTangentSpace:he&&v.normalMapType===Th,packedNormalMap:he&&v.normalMapType===Th&&Wx(v.normalMap.format),metalnessMap:Ze,roughnessMap:Je,anisotropy:Qe,anisotropyMap:It,clearcoat:I,clearcoatMap:b,clearcoatNormalMap:_,clearcoatRoughnessMap:O,diffuseRoughness:je,diffuseRoughnessMap:tt,dispersion:le,retroreflection:ce,iridescence:ut,iridescenceMap:J,iridescenceThicknessMap:st,sheen:Se,sheenColorMap:ct,sheenRoughnessMap:q,specularMap:$,specularColorMap:at,specularIntensityMap:R,transmission:Ct,transmissionMap:K,thicknessMap:V,gradientMap:ot,opaque:v.transparent===!1&&v.blending===qs&&v.alphaToCoverage===!1,alphaMap:it,alphaTest:rt,alphaHash:Et,combine:v.combine,mapUv:Lt&&f(v.map.channel),aoMapUv:Ce&&f(v.aoMap.channel),lightMapUv:we&&f(v.lightMap.channel),bumpMapUv:Ge&&f(v.bumpMap.channel),normalMapUv:he&&f(v.normalMap.channel),displacementMapUv:wn&&f(v.displacementMap.channel),emissiveMapUv:Ee&&f(v.emissiveMap.channel),metalnessMapUv:Ze&&f(v.metalnessMap.channel),roughnessMapUv:Je&&f(v.roughnessMap.channel),anisotropyMapUv:It&&f(v.anisotropyMap.channel),clearcoatMapUv:b&&f(v.clearcoatMap.channel),clearcoatNormalMapUv:_&&f(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:O&&f(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:tt&&f(v.diffuseRoughnessMap.channel),iridescenceMapUv:J&&f(v.iridescenceMap.channel),iridescenceThicknessMapUv:st&&f(v.iridescenceThicknessMap.channel),sheenColorMapUv:ct&&f(v.sheenColorMap.channel),sheenRoughnessMapUv:q&&f(v.sheenRoughnessMap.channel),specularMapUv:$&&f(v.specularMap.channel),specularColorMapUv:at&&f(v.specularColorMap.channel),specularIntensityMapUv:R&&f(v.specularIntensityMap.channel),transmissionMapUv:K&&f(v.transmissionMap.channel),thicknessMapUv:V&&f(v.thicknessMap.channel),alphaMapUv:it&&f(v.alphaMap.channel),vertexTangents:!!C.attributes.tangent&&(he||Qe),vertexNormals:!!C.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!C.attributes.color&&C.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!C.attributes.uv&&(Lt||it),fog:!!W,useFog:v.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||C.attributes.normal===void 0&&he===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:gt,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:C.attributes.position!==void 0,morphTargets:C.morphAttributes.position!==void 0,morphNormals:C.morphAttributes.normal!==void 0,morphColors:C.morphAttributes.color!==void 0,morphTargetsCount:j,morphTextureStride:Mt,numSunLights:y.sun.length,numDirLights:y.directional.length,numPointLights:y.point.length,numSpotLights:y.spot.length,numSpotLightMaps:y.spotLightMap.length,numRectAreaLights:y.rectArea.length,numHemiLights:y.hemi.length,numSunLightShadows:y.sunShadowMap.length,numDirLightShadows:y.directionalShadowMap.length,numPointLightShadows:y.pointShadowMap.length,numSpotLightShadows:y.spotShadowMap.length,numSpotLightShadowsWithMaps:y.numSpotLightShadowsWithMaps,numLightProbes:y.numLightProbes,numLightProbeGrids:B.filter(dt=>dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:i.shadowMap.enabled&&N.length>0,shadowMapType:i.shadowMap.type,toneMapping:nt,decodeVideoTexture:Lt&&v.map.isVideoTexture===!0&&qt.getTransfer(v.map.colorSpace)===ne,decodeVideoTextureEmissive:Ee&&v.emissiveMap.isVideoTexture===!0&&qt.getTransfer(v.emissiveMap.colorSpace)===ne,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Ln,flipSided:v.side===Ve,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Bt&&v.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Bt&&v.extensions.multiDraw===!0||pe)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return Ot.vertexUv1s=l.has(1),Ot.vertexUv2s=l.has(2),Ot.vertexUv3s=l.has(3),l.clear(),Ot}function x(v){const y=[];if(v.shaderID?y.push(v.shaderID):(y.push(v.customVertexShaderID),y.push(v.customFragmentShaderID)),v.defines!==void 0)for(const N in v.defines)y.push(N),y.push(v.defines[N]);return v.isRawShaderMaterial===!1&&(g(y,v),p(y,v),y.push(i.outputColorSpace)),y.push(v.customProgramCacheKey),y.join()}function g(v,y){v.push(y.precision),v.push(y.outputColorSpace),v.push(y.envMapMode),v.push(y.envMapPMREM),v.push(y.envMapMaxLod),v.push(y.envMapSize),v.push(y.mapUv),v.push(y.alphaMapUv),v.push(y.lightMapUv),v.push(y.aoMapUv),v.push(y.bumpMapUv),v.push(y.normalMapUv),v.push(y.displacementMapUv),v.push(y.emissiveMapUv),v.push(y.metalnessMapUv),v.push(y.roughnessMapUv),v.push(y.anisotropyMapUv),v.push(y.clearcoatMapUv),v.push(y.clearcoatNormalMapUv),v.push(y.clearcoatRoughnessMapUv),v.push(y.diffuseRoughnessMapUv),v.push(y.iridescenceMapUv),v.push(y.iridescenceThicknessMapUv),v.push(y.sheenColorMapUv),v.push(y.sheenRoughnessMapUv),v.push(y.specularMapUv),v.push(y.specularColorMapUv),v.push(y.specularIntensityMapUv),v.push(y.transmissionMapUv),v.push(y.thicknessMapUv),v.push(y.combine),v.push(y.fogExp2),v.push(y.sizeAttenuation),v.push(y.morphTargetsCount),v.push(y.numSunLights),v.push(y.numDirLights),v.push(y.numPointLights),v.push(y.numSpotLights),v.push(y.numSpotLightMaps),v.push(y.numHemiLights),v.push(y.numRectAreaLights),v.push(y.numSunLightShadows),v.push(y.numDirLightShadows),v.push(y.numPointLightShadows),v.push(y.numSpotLightShadows),v.push(y.numSpotLightShadowsWithMaps),v.push(y.numLightProbes),v.push(y.numLightProbeGrids),v.push(y.shadowMapType),v.push(y.toneMapping),v.push(y.numClippingPlanes),v.push(y.numClipIntersection),v.push(y.depthPacking)}function p(v,y){a.disableAll(),y.instancing&&a.enable(0),y.instancingColor&&a.enable(1),y.instancingMorph&&a.enable(2),y.matcap&&a.enable(3),y.envMap&&a.enable(4),y.normalMapObjectSpace&&a.enable(5),y.normalMapTangentSpace&&a.enable(6),y.clearcoat&&a.enable(7),y.iridescence&&a.enable(8),y.alphaTest&&a.enable(9),y.vertexColors&&a.enable(10),y.vertexAlphas&&a.enable(11),y.vertexUv1s&&a.enable(12),y.vertexUv2s&&a.enable(13),y.vertexUv3s&&a.enable(14),y.vertexTangents&&a.enable(15),y.anisotropy&&a.enable(16),y.alphaHash&&a.enable(17),y.batching&&a.enable(18),y.dispersion&&a.enable(19),y.retroreflection&&a.enable(24),y.diffuseRoughness&&a.enable(25),y.batchingColor&&a.enable(20),y.gradientMap&&a.enable(21),y.packedNormalMap&&a.enable(22),y.vertexNormals&&a.enable(23),v.push(a.mask),a.disableAll(),y.fog&&a.enable(0),y.useFog&&a.enable(1),y.flatShading&&a.enable(2),y.logarithmicDepthBuffer&&a.enable(3),y.reversedDepthBuffer&&a.enable(4),y.skinning&&a.enable(5),y.morphTargets&&a.enable(6),y.morphNormals&&a.enable(7),y.morphColors&&a.enable(8),y.premultipliedAlpha&&a.enable(9),y.shadowMapEnabled&&a.enable(10),y.doubleSided&&a.enable(11),y.flipSided&&a.enable(12),y.useDepthPacking&&a.enable(13),y.dithering&&a.enable(14),y.transmission&&a.enable(15),y.sheen&&a.enable(16),y.opaque&&a.enable(17),y.pointsUvs&&a.enable(18),y.decodeVideoTexture&&a.enable(19),y.decodeVideoTextureEmissive&&a.enable(20),y.alphaToCoverage&&a.enable(21),y.numLightProbeGrids>0&&a.enable(22),y.hasPositionAttribute&&a.enable(23),v.push(a.mask)}function S(v){const y=d[v.type];let N;if(y){const P=Rn[y];N=_0.clone(P.uniforms)}else N=v.uniforms;return N}function T(v,y){let N=h.get(y);return N!==void 0?++N.usedTimes:(N=new zx(i,y,v,s),c.push(N),h.set(y,N)),N}function M(v){if(--v.usedTimes===0){const y=c.indexOf(v);c[y]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function A(v){o.remove(v)}function E(){o.dispose()}return{getParameters:m,getProgramCacheKey:x,getUniforms:S,acquireProgram:T,releaseProgram:M,releaseShaderCache:A,programs:c,dispose:E}}function qx(){let i=new WeakMap;function t(a){return i.has(a)}function e(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,l){i.get(a)[o]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function $x(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function uu(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function du(){const i=[];let t=0;const e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function a(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function o(d,f,m,x,g,p){let S=i[t];return S===void 0?(S={id:d.id,object:d,geometry:f,material:m,materialVariant:a(d),groupOrder:x,renderOrder:d.renderOrder,z:g,group:p},i[t]=S):(S.id=d.id,S.object=d,S.geometry=f,S.material=m,S.materialVariant=a(d),S.groupOrder=x,S.renderOrder=d.renderOrder,S.z=g,S.group=p),t++,S}function l(d,f,m,x,g,p,S){S.reversedDepth===!0&&(g=-g);const T=o(d,f,m,x,g,p);m.transmission>0?n.push(T):m.transparent===!0?s.push(T):e.push(T)}function c(d,f,m,x,g,p){const S=o(d,f,m,x,g,p);m.transmission>0?n.unshift(S):m.transparent===!0?s.unshift(S):e.unshift(S)}function h(d,f){e.length>1&&e.sort(d||$x),n.length>1&&n.sort(f||uu),s.length>1&&s.sort(f||uu)}function u(){for(let d=t,f=i.length;d<f;d++){const m=i[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function Yx(){let i=new WeakMap;function t(n,s){const r=i.get(n);let a;return r===void 0?(a=new du,i.set(n,[a])):s>=r.length?(a=new du,r.push(a)):a=r[s],a}function e(){i=new WeakMap}return{get:t,dispose:e}}function Kx(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new F,color:new Gt};break;case"SpotLight":e={position:new F,direction:new F,color:new Gt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new F,color:new Gt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new F,skyColor:new Gt,groundColor:new Gt};break;case"RectAreaLight":e={color:new Gt,position:new F,halfWidth:new F,halfHeight:new F};break}return i[t.id]=e,e}}}function Zx(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}let Jx=0;function Qx(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function jx(i){const t=new Kx,e=Zx(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new F);const s=new F,r=new Qt,a=new Qt;function o(c){let h=0,u=0,d=0;for(let B=0;B<9;B++)n.probe[B].set(0,0,0);let f=0,m=0,x=0,g=0,p=0,S=0,T=0,M=0,A=0,E=0,v=0,y=0,N=0,P=0;c.sort(Qx);for(let B=0,W=c.length;B<W;B++){const C=c[B],H=C.color,Z=C.intensity,G=C.distance;let et=null;if(C.shadow&&C.shadow.map&&(C.shadow.map.texture.format===vi?et=C.shadow.map.texture:et=C.shadow.map.depthTexture||C.shadow.map.texture),C.isAmbientLight)h+=H.r*Z,u+=H.g*Z,d+=H.b*Z;else if(C.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(C.sh.coefficients[X],Z);P++}else if(C.isSunLight){const X=t.get(C);if(X.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const Q=C.shadow,j=e.get(C);j.shadowIntensity=Q.intensity,j.shadowBias=Q.bias,j.shadowNormalBias=Q.normalBias,j.shadowRadius=Q.radius,j.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[m]=j,n.sunShadowMap[m]=et;const Mt=Q.getViewportCount();for(let Nt=0;Nt<Mt;Nt++)n.sunShadowMatrix[x+Nt]=Q.getMatrix(Nt),n.sunShadowCascade[x+Nt]=Q._cascadeData[Nt];x+=Mt,m++}n.sun[f]=X,f++}else if(C.isDirectionalLight){const X=t.get(C);if(X.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const Q=C.shadow,j=e.get(C);j.shadowIntensity=Q.intensity,j.shadowBias=Q.bias,j.shadowNormalBias=Q.normalBias,j.shadowRadius=Q.radius,j.shadowMapSize=Q.mapSize,n.directionalShadow[g]=j,n.directionalShadowMap[g]=et,n.directionalShadowMatrix[g]=C.shadow.matrix,A++}n.directional[g]=X,g++}else if(C.isSpotLight){const X=t.get(C);X.position.setFromMatrixPosition(C.matrixWorld),X.color.copy(H).multiplyScalar(Z),X.distance=G,X.coneCos=Math.cos(C.angle),X.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),X.decay=C.decay,n.spot[S]=X;const Q=C.shadow;if(C.map&&(n.spotLightMap[y]=C.map,y++,Q.updateMatrices(C),C.castShadow&&N++),n.spotLightMatrix[S]=Q.matrix,C.castShadow){const j=e.get(C);j.shadowIntensity=Q.intensity,j.shadowBias=Q.bias,j.shadowNormalBias=Q.normalBias,j.shadowRadius=Q.radius,j.shadowMapSize=Q.mapSize,n.spotShadow[S]=j,n.spotShadowMap[S]=et,v++}S++}else if(C.isRectAreaLight){const X=t.get(C);X.color.copy(H).multiplyScalar(Z),X.halfWidth.set(C.width*.5,0,0),X.halfHeight.set(0,C.height*.5,0),n.rectArea[T]=X,T++}else if(C.isPointLight){const X=t.get(C);if(X.color.copy(C.color).multiplyScalar(C.intensity),X.distance=C.distance,X.decay=C.decay,C.castShadow){const Q=C.shadow,j=e.get(C);j.shadowIntensity=Q.intensity,j.shadowBias=Q.bias,j.shadowNormalBias=Q.normalBias,j.shadowRadius=Q.radius,j.shadowMapSize=Q.mapSize,j.shadowCameraNear=Q.camera.near,j.shadowCameraFar=Q.camera.far,n.pointShadow[p]=j,n.pointShadowMap[p]=et,n.pointShadowMatrix[p]=C.shadow.matrix,E++}n.point[p]=X,p++}else if(C.isHemisphereLight){const X=t.get(C);X.skyColor.copy(C.color).multiplyScalar(Z),X.groundColor.copy(C.groundColor).multiplyScalar(Z),n.hemi[M]=X,M++}}T>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ft.LTC_FLOAT_1,n.rectAreaLTC2=ft.LTC_FLOAT_2):(n.rectAreaLTC1=ft.LTC_HALF_1,n.rectAreaLTC2=ft.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;const D=n.hash;(D.sunLength!==f||D.directionalLength!==g||D.pointLength!==p||D.spotLength!==S||D.rectAreaLength!==T||D.hemiLength!==M||D.numSunShadows!==m||D.numDirectionalShadows!==A||D.numPointShadows!==E||D.numSpotShadows!==v||D.numSpotMaps!==y||D.numLightProbes!==P)&&(n.sun.length=f,n.directional.length=g,n.spot.length=S,n.rectArea.length=T,n.point.length=p,n.hemi.length=M,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=A,n.directionalShadowMap.length=A,n.directionalShadowMatrix.length=A,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=v,n.spotShadowMap.length=v,n.spotLightMatrix.length=v+y-N,n.spotLightMap.length=y,n.numSpotLightShadowsWithMaps=N,n.numLightProbes=P,D.sunLength=f,D.directionalLength=g,D.pointLength=p,D.spotLength=S,D.rectAreaLength=T,D.hemiLength=M,D.numSunShadows=m,D.numDirectionalShadows=A,D.numPointShadows=E,D.numSpotShadows=v,D.numSpotMaps=y,D.numLightProbes=P,n.version=Jx++)}function l(c,h){let u=0,d=0,f=0,m=0,x=0,g=0;const p=h.matrixWorldInverse;for(let S=0,T=c.length;S<T;S++){const M=c[S];if(M.isSunLight){const A=n.sun[u];A.direction.setFromMatrixPosition(M.matrixWorld),A.direction.transformDirection(p),u++}else if(M.isDirectionalLight){const A=n.directional[d];A.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(p),d++}else if(M.isSpotLight){const A=n.spot[m];A.position.setFromMatrixPosition(M.matrixWorld),A.position.applyMatrix4(p),A.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(p),m++}else if(M.isRectAreaLight){const A=n.rectArea[x];A.position.setFromMatrixPosition(M.matrixWorld),A.position.applyMatrix4(p),a.identity(),r.copy(M.matrixWorld),r.premultiply(p),a.extractRotation(r),A.halfWidth.set(M.width*.5,0,0),A.halfHeight.set(0,M.height*.5,0),A.halfWidth.applyMatrix4(a),A.halfHeight.applyMatrix4(a),x++}else if(M.isPointLight){const A=n.point[f];A.position.setFromMatrixPosition(M.matrixWorld),A.position.applyMatrix4(p),f++}else if(M.isHemisphereLight){const A=n.hemi[g];A.direction.setFromMatrixPosition(M.matrixWorld),A.direction.transformDirection(p),g++}}}return{setup:o,setupView:l,state:n}}function fu(i){const t=new jx(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function a(u){u.isLightProbeGrid?s.push(u):e.push(u)}function o(u){n.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}const h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function tw(i){let t=new WeakMap;function e(s,r=0){const a=t.get(s);let o;return a===void 0?(o=new fu(i),t.set(s,[o])):r>=a.length?(o=new fu(i),a.push(o)):o=a[r],o}function n(){t=new WeakMap}return{get:e,dispose:n}}const ew=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,nw=`uniform sampler2D shadow_pass;
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
}`,iw=[new F(1,0,0),new F(-1,0,0),new F(0,1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1)],sw=[new F(0,-1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1),new F(0,-1,0),new F(0,-1,0)],pu=new Qt,Es=new F,To=new F;function rw(i,t,e){let n=new Ea;const s=new Kt,r=new Kt,a=new de,o=new S0,l=new M0,c={},h=e.maxTextureSize,u={[mi]:Ve,[Ve]:mi,[Ln]:Ln},d=new Bi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Kt},radius:{value:4}},vertexShader:ew,fragmentShader:nw}),f=d.clone();f.defines.HORIZONTAL_PASS=1;const m=new Fn;m.setAttribute("position",new on(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const x=new Nn(m,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ea;let p=this.type;this.render=function(E,v,y){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||E.length===0)return;this.type===am&&(Pt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ea);const N=i.getRenderTarget(),P=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),B=i.state;B.setBlending(os),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);const W=p!==this.type;W&&v.traverse(function(C){C.material&&(Array.isArray(C.material)?C.material.forEach(H=>H.needsUpdate=!0):C.material.needsUpdate=!0)});for(let C=0,H=E.length;C<H;C++){const Z=E[C],G=Z.shadow;if(G===void 0){Pt("WebGLShadowMap:",Z,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);const et=G.getFrameExtents();s.multiply(et),r.copy(G.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/et.x),s.x=r.x*et.x,G.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/et.y),s.y=r.y*et.y,G.mapSize.y=r.y));const X=i.state.buffers.depth.getReversed();if(G.camera._reversedDepth=X,G.map===null||W===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Gs){if(Z.isPointLight){Pt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new _n(s.x,s.y,{format:vi,type:xn,minFilter:Fe,magFilter:Fe,generateMipmaps:!1}),G.map.texture.name=Z.name+".shadowMap",G.map.depthTexture=new ki(s.x,s.y,rn),G.map.depthTexture.name=Z.name+".shadowMapDepth",G.map.depthTexture.format=gi,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=xe,G.map.depthTexture.magFilter=xe}else Z.isPointLight?(G.map=new Nc(s.x),G.map.depthTexture=new mf(s.x,ln)):(G.map=new _n(s.x,s.y),G.map.depthTexture=new ki(s.x,s.y,ln)),G.map.depthTexture.name=Z.name+".shadowMap",G.map.depthTexture.format=gi,this.type===ea?(G.map.depthTexture.compareFunction=X?af:Rc,G.map.depthTexture.minFilter=Fe,G.map.depthTexture.magFilter=Fe):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=xe,G.map.depthTexture.magFilter=xe);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);const Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();Z.isPointLight!==!0&&G.updateMatrices(Z,y);const j=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:y.layers;for(let Mt=0;Mt<Q;Mt++){const Nt=G.getCamera(Mt);if(Z.isPointLight){const Y=G.camera,pt=G.matrix,xt=Z.distance||Y.far;xt!==Y.far&&(Y.far=xt,Y.updateProjectionMatrix()),Es.setFromMatrixPosition(Z.matrixWorld),Y.position.copy(Es),To.copy(Y.position),To.add(iw[Mt]),Y.up.copy(sw[Mt]),Y.lookAt(To),Y.updateMatrixWorld(),pt.makeTranslation(-Es.x,-Es.y,-Es.z),pu.multiplyMatrices(Y.projectionMatrix,Y.matrixWorldInverse),G._frustum.setFromProjectionMatrix(pu,Y.coordinateSystem,Y.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)i.setRenderTarget(G.map,Mt),i.clear();else{Mt===0&&(i.setRenderTarget(G.map),i.clear());const Y=G.getViewport(Mt);a.set(r.x*Y.x,r.y*Y.y,r.x*Y.z,r.y*Y.w),B.viewport(a)}n=G.getFrustum(Mt),M(v,y,Nt,Z,j,this.type)}G.isPointLightShadow!==!0&&this.type===Gs&&S(G,y),G.needsUpdate=!1}p=this.type,g.needsUpdate=!1,i.setRenderTarget(N,P,D)};function S(E,v){const y=t.update(x);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new _n(s.x,s.y,{format:vi,type:xn}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(v,null,y,d,x,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(v,null,y,f,x,null)}function T(E,v,y,N){let P=null;const D=y.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)P=D;else if(P=y.isPointLight===!0?l:o,i.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){const B=P.uuid,W=v.uuid;let C=c[B];C===void 0&&(C={},c[B]=C);let H=C[W];H===void 0&&(H=P.clone(),C[W]=H,v.addEventListener("dispose",A)),P=H}if(P.visible=v.visible,P.wireframe=v.wireframe,N===Gs?P.side=v.shadowSide!==null?v.shadowSide:v.side:P.side=v.shadowSide!==null?v.shadowSide:u[v.side],P.alphaMap=v.alphaMap,P.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,P.map=v.map,P.clipShadows=v.clipShadows,P.clippingPlanes=v.clippingPlanes,P.clipIntersection=v.clipIntersection,P.displacementMap=v.displacementMap,P.displacementScale=v.displacementScale,P.displacementBias=v.displacementBias,P.wireframeLinewidth=v.wireframeLinewidth,P.linewidth=v.linewidth,y.isPointLight===!0&&P.isMeshDistanceMaterial===!0){const B=i.properties.get(P);B.light=y}return P}function M(E,v,y,N,P,D){if(E.visible===!1)return;if(E.layers.test(P)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===Gs)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(y.matrixWorldInverse,E.matrixWorld);const C=t.update(E),H=E.material;if(Array.isArray(H)){const Z=C.groups;for(let G=0,et=Z.length;G<et;G++){const X=Z[G],Q=H[X.materialIndex];if(Q&&Q.visible){const j=T(E,Q,N,D);E.onBeforeShadow(i,E,v,y,C,j,X),i.renderBufferDirect(y,null,C,j,E,X),E.onAfterShadow(i,E,v,y,C,j,X)}}}else if(H.visible){const Z=T(E,H,N,D);E.onBeforeShadow(i,E,v,y,C,Z,null),i.renderBufferDirect(y,null,C,Z,E,null),E.onAfterShadow(i,E,v,y,C,Z,null)}}const W=E.children;for(let C=0,H=W.length;C<H;C++)M(W[C],v,y,N,P,D)}function A(E){E.target.removeEventListener("dispose",A);for(const y in c){const N=c[y],P=E.target.uuid;P in N&&(N[P].dispose(),delete N[P])}}}function aw(i,t){function e(){let R=!1;const K=new de;let V=null;const ot=new de(0,0,0,0);return{setMask:function(it){V!==it&&!R&&(i.colorMask(it,it,it,it),V=it)},setLocked:function(it){R=it},setClear:function(it,rt,Et,Bt,nt){nt===!0&&(it*=Bt,rt*=Bt,Et*=Bt),K.set(it,rt,Et,Bt),ot.equals(K)===!1&&(i.clearColor(it,rt,Et,Bt),ot.copy(K))},reset:function(){R=!1,V=null,ot.set(-1,0,0,0)}}}function n(){let R=!1,K=!1,V=null,ot=null,it=null;return{setReversed:function(rt){if(K!==rt){const Et=t.get("EXT_clip_control");rt?Et.clipControlEXT(Et.LOWER_LEFT_EXT,Et.ZERO_TO_ONE_EXT):Et.clipControlEXT(Et.LOWER_LEFT_EXT,Et.NEGATIVE_ONE_TO_ONE_EXT),K=rt;const Bt=it;it=null,this.setClear(Bt)}},getReversed:function(){return K},setTest:function(rt){rt?gt(i.DEPTH_TEST):Ft(i.DEPTH_TEST)},setMask:function(rt){V!==rt&&!R&&(i.depthMask(rt),V=rt)},setFunc:function(rt){if(K&&(rt=zm[rt]),ot!==rt){switch(rt){case sl:i.depthFunc(i.NEVER);break;case rl:i.depthFunc(i.ALWAYS);break;case al:i.depthFunc(i.LESS);break;case js:i.depthFunc(i.LEQUAL);break;case ol:i.depthFunc(i.EQUAL);break;case ll:i.depthFunc(i.GEQUAL);break;case cl:i.depthFunc(i.GREATER);break;case hl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ot=rt}},setLocked:function(rt){R=rt},setClear:function(rt){it!==rt&&(it=rt,K&&(rt=1-rt),i.clearDepth(rt))},reset:function(){R=!1,V=null,ot=null,it=null,K=!1}}}function s(){let R=!1,K=null,V=null,ot=null,it=null,rt=null,Et=null,Bt=null,nt=null;return{setTest:function(Tt){R||(Tt?gt(i.STENCIL_TEST):Ft(i.STENCIL_TEST))},setMask:function(Tt){K!==Tt&&!R&&(i.stencilMask(Tt),K=Tt)},setFunc:function(Tt,Ot,dt){(V!==Tt||ot!==Ot||it!==dt)&&(i.stencilFunc(Tt,Ot,dt),V=Tt,ot=Ot,it=dt)},setOp:function(Tt,Ot,dt){(rt!==Tt||Et!==Ot||Bt!==dt)&&(i.stencilOp(Tt,Ot,dt),rt=Tt,Et=Ot,Bt=dt)},setLocked:function(Tt){R=Tt},setClear:function(Tt){nt!==Tt&&(i.clearStencil(Tt),nt=Tt)},reset:function(){R=!1,K=null,V=null,ot=null,it=null,rt=null,Et=null,Bt=null,nt=null}}}const r=new e,a=new n,o=new s;let l={};const c=new WeakMap;let h={},u={},d={},f=new WeakMap,m=[],x=null,g=!1,p=null,S=null,T=null,M=null,A=null,E=null,v=null,y=new Gt(0,0,0),N=0,P=!1,D=null,B=null,W=null,C=null,H=null;const Z=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let G=!1,et=0;const X=i.getParameter(i.VERSION);X.indexOf("WebGL")!==-1?(et=parseFloat(/^WebGL (\d)/.exec(X)[1]),G=et>=1):X.indexOf("OpenGL ES")!==-1&&(et=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),G=et>=2);let Q=null,j={};const Mt=i.getParameter(i.SCISSOR_BOX),Nt=i.getParameter(i.VIEWPORT),Y=new de().fromArray(Mt),pt=new de().fromArray(Nt);function xt(R,K,V,ot){const it=new Uint8Array(4),rt=i.createTexture();i.bindTexture(R,rt),i.texParameteri(R,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(R,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Et=0;Et<V;Et++)R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY?i.texImage3D(K,0,i.RGBA,1,1,ot,0,i.RGBA,i.UNSIGNED_BYTE,it):i.texImage2D(K+Et,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,it);return rt}const Rt={};Rt[i.TEXTURE_2D]=xt(i.TEXTURE_2D,i.TEXTURE_2D,1),Rt[i.TEXTURE_CUBE_MAP]=xt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Rt[i.TEXTURE_2D_ARRAY]=xt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Rt[i.TEXTURE_3D]=xt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),gt(i.DEPTH_TEST),a.setFunc(js),Ge(!1),he(Mh),gt(i.CULL_FACE),Ce(os);function gt(R){h[R]!==!0&&(i.enable(R),h[R]=!0)}function Ft(R){h[R]!==!1&&(i.disable(R),h[R]=!1)}function pe(R,K){return d[R]!==K?(i.bindFramebuffer(R,K),d[R]=K,R===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=K),R===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=K),!0):!1}function Lt(R,K){let V=m,ot=!1;if(R){V=f.get(K),V===void 0&&(V=[],f.set(K,V));const it=R.textures;if(V.length!==it.length||V[0]!==i.COLOR_ATTACHMENT0){for(let rt=0,Et=it.length;rt<Et;rt++)V[rt]=i.COLOR_ATTACHMENT0+rt;V.length=it.length,ot=!0}}else V[0]!==i.BACK&&(V[0]=i.BACK,ot=!0);ot&&i.drawBuffers(V)}function te(R){return x!==R?(i.useProgram(R),x=R,!0):!1}const ie={[es]:i.FUNC_ADD,[lm]:i.FUNC_SUBTRACT,[cm]:i.FUNC_REVERSE_SUBTRACT};ie[hm]=i.MIN,ie[um]=i.MAX;const Ht={[dm]:i.ZERO,[fm]:i.ONE,[pm]:i.SRC_COLOR,[Gd]:i.SRC_ALPHA,[wm]:i.SRC_ALPHA_SATURATE,[_m]:i.DST_COLOR,[gm]:i.DST_ALPHA,[mm]:i.ONE_MINUS_SRC_COLOR,[Hd]:i.ONE_MINUS_SRC_ALPHA,[xm]:i.ONE_MINUS_DST_COLOR,[vm]:i.ONE_MINUS_DST_ALPHA,[Sm]:i.CONSTANT_COLOR,[Mm]:i.ONE_MINUS_CONSTANT_COLOR,[ym]:i.CONSTANT_ALPHA,[Em]:i.ONE_MINUS_CONSTANT_ALPHA};function Ce(R,K,V,ot,it,rt,Et,Bt,nt,Tt){if(R===os){g===!0&&(Ft(i.BLEND),g=!1);return}if(g===!1&&(gt(i.BLEND),g=!0),R!==om){if(R!==p||Tt!==P){if((S!==es||A!==es)&&(i.blendEquation(i.FUNC_ADD),S=es,A=es),Tt)switch(R){case qs:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case yh:i.blendFunc(i.ONE,i.ONE);break;case Eh:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case bh:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Jt("WebGLState: Invalid blending: ",R);break}else switch(R){case qs:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case yh:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Eh:Jt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case bh:Jt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Jt("WebGLState: Invalid blending: ",R);break}T=null,M=null,E=null,v=null,y.set(0,0,0),N=0,p=R,P=Tt}return}it=it||K,rt=rt||V,Et=Et||ot,(K!==S||it!==A)&&(i.blendEquationSeparate(ie[K],ie[it]),S=K,A=it),(V!==T||ot!==M||rt!==E||Et!==v)&&(i.blendFuncSeparate(Ht[V],Ht[ot],Ht[rt],Ht[Et]),T=V,M=ot,E=rt,v=Et),(Bt.equals(y)===!1||nt!==N)&&(i.blendColor(Bt.r,Bt.g,Bt.b,nt),y.copy(Bt),N=nt),p=R,P=!1}function we(R,K){R.side===Ln?Ft(i.CULL_FACE):gt(i.CULL_FACE);let V=R.side===Ve;K&&(V=!V),Ge(V),R.blending===qs&&R.transparent===!1?Ce(os):Ce(R.blending,R.blendEquation,R.blendSrc,R.blendDst,R.blendEquationAlpha,R.blendSrcAlpha,R.blendDstAlpha,R.blendColor,R.blendAlpha,R.premultipliedAlpha),a.setFunc(R.depthFunc),a.setTest(R.depthTest),a.setMask(R.depthWrite),r.setMask(R.colorWrite);const ot=R.stencilWrite;o.setTest(ot),ot&&(o.setMask(R.stencilWriteMask),o.setFunc(R.stencilFunc,R.stencilRef,R.stencilFuncMask),o.setOp(R.stencilFail,R.stencilZFail,R.stencilZPass)),Ee(R.polygonOffset,R.polygonOffsetFactor,R.polygonOffsetUnits),R.alphaToCoverage===!0?gt(i.SAMPLE_ALPHA_TO_COVERAGE):Ft(i.SAMPLE_ALPHA_TO_COVERAGE)}function Ge(R){D!==R&&(R?i.frontFace(i.CW):i.frontFace(i.CCW),D=R)}function he(R){R!==sm?(gt(i.CULL_FACE),R!==B&&(R===Mh?i.cullFace(i.BACK):R===rm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ft(i.CULL_FACE),B=R}function wn(R){R!==W&&(G&&i.lineWidth(R),W=R)}function Ee(R,K,V){R?(gt(i.POLYGON_OFFSET_FILL),(C!==K||H!==V)&&(C=K,H=V,a.getReversed()&&(K=-K,V=-V),i.polygonOffset(K,V))):Ft(i.POLYGON_OFFSET_FILL)}function Ze(R){R?gt(i.SCISSOR_TEST):Ft(i.SCISSOR_TEST)}function Je(R){R===void 0&&(R=i.TEXTURE0+Z-1),Q!==R&&(i.activeTexture(R),Q=R)}function Qe(R,K,V){V===void 0&&(Q===null?V=i.TEXTURE0+Z-1:V=Q);let ot=j[V];ot===void 0&&(ot={type:void 0,texture:void 0},j[V]=ot),(ot.type!==R||ot.texture!==K)&&(Q!==V&&(i.activeTexture(V),Q=V),i.bindTexture(R,K||Rt[R]),ot.type=R,ot.texture=K)}function I(){const R=j[Q];R!==void 0&&R.type!==void 0&&(i.bindTexture(R.type,null),R.type=void 0,R.texture=void 0)}function je(){try{i.compressedTexImage2D(...arguments)}catch(R){Jt("WebGLState:",R)}}function le(){try{i.compressedTexImage3D(...arguments)}catch(R){Jt("WebGLState:",R)}}function ce(){try{i.texSubImage2D(...arguments)}catch(R){Jt("WebGLState:",R)}}function ut(){try{i.texSubImage3D(...arguments)}catch(R){Jt("WebGLState:",R)}}function Se(){try{i.compressedTexSubImage2D(...arguments)}catch(R){Jt("WebGLState:",R)}}function Ct(){try{i.compressedTexSubImage3D(...arguments)}catch(R){Jt("WebGLState:",R)}}function It(){try{i.texStorage2D(...arguments)}catch(R){Jt("WebGLState:",R)}}function b(){try{i.texStorage3D(...arguments)}catch(R){Jt("WebGLState:",R)}}function _(){try{i.texImage2D(...arguments)}catch(R){Jt("WebGLState:",R)}}function O(){try{i.texImage3D(...arguments)}catch(R){Jt("WebGLState:",R)}}function tt(R){return u[R]!==void 0?u[R]:i.getParameter(R)}function J(R,K){u[R]!==K&&(i.pixelStorei(R,K),u[R]=K)}function st(R){Y.equals(R)===!1&&(i.scissor(R.x,R.y,R.z,R.w),Y.copy(R))}function ct(R){pt.equals(R)===!1&&(i.viewport(R.x,R.y,R.z,R.w),pt.copy(R))}function q(R,K){let V=c.get(K);V===void 0&&(V=new WeakMap,c.set(K,V));let ot=V.get(R);ot===void 0&&(ot=i.getUniformBlockIndex(K,R.name),i.uniformBlockBinding(K,ot,ot),V.set(R,ot))}function $(R,K,V){const it=c.get(K).get(R);l[it]!==V&&(i.bindBufferBase(i.UNIFORM_BUFFER,it,V),l[it]=V)}function at(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,j={},d={},l={},f=new WeakMap,m=[],x=null,g=!1,p=null,S=null,T=null,M=null,A=null,E=null,v=null,y=new Gt(0,0,0),N=0,P=!1,D=null,B=null,W=null,C=null,H=null,Y.set(0,0,i.canvas.width,i.canvas.height),pt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:gt,disable:Ft,bindFramebuffer:pe,drawBuffers:Lt,useProgram:te,setBlending:Ce,setMaterial:we,setFlipSided:Ge,setCullFace:he,setLineWidth:wn,setPolygonOffset:Ee,setScissorTest:Ze,activeTexture:Je,bindTexture:Qe,unbindTexture:I,compressedTexImage2D:je,compressedTexImage3D:le,texImage2D:_,texImage3D:O,pixelStorei:J,getParameter:tt,updateUBOMapping:q,uniformBlockBinding:$,texStorage2D:It,texStorage3D:b,texSubImage2D:ce,texSubImage3D:ut,compressedTexSubImage2D:Se,compressedTexSubImage3D:Ct,scissor:st,viewport:ct,reset:at}}function ow(i,t,e,n,s,r,a){const o=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Kt,h=new WeakMap,u=new Set;let d;const f=new WeakMap,m=new Set,x=new FinalizationRegistry(b=>m.delete(b));let g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(b,_){return g?new OffscreenCanvas(b,_):ya("canvas")}function S(b,_,O){let tt=1;const J=It(b);if((J.width>O||J.height>O)&&(tt=O/Math.max(J.width,J.height)),tt<1)if(typeof HTMLImageElement<"u"&&b instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&b instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&b instanceof ImageBitmap||typeof VideoFrame<"u"&&b instanceof VideoFrame){const st=Math.floor(tt*J.width),ct=Math.floor(tt*J.height);d===void 0&&(d=p(st,ct));const q=_?p(st,ct):d;return q.width=st,q.height=ct,q.getContext("2d").drawImage(b,0,0,st,ct),Pt("WebGLRenderer: Texture has been resized from ("+J.width+"x"+J.height+") to ("+st+"x"+ct+")."),q}else return"data"in b&&Pt("WebGLRenderer: Image in DataTexture is too big ("+J.width+"x"+J.height+")."),b;return b}function T(b){return b.generateMipmaps}function M(b){i.generateMipmap(b)}function A(b){return b.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:b.isWebGL3DRenderTarget?i.TEXTURE_3D:b.isWebGLArrayRenderTarget||b.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(b,_,O,tt,J,st=!1){if(b!==null){if(i[b]!==void 0)return i[b];Pt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+b+"'")}let ct;tt&&(ct=t.get("EXT_texture_norm16"),ct||Pt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let q=_;if(_===i.RED&&(O===i.FLOAT&&(q=i.R32F),O===i.HALF_FLOAT&&(q=i.R16F),O===i.UNSIGNED_BYTE&&(q=i.R8),O===i.UNSIGNED_SHORT&&ct&&(q=ct.R16_EXT),O===i.SHORT&&ct&&(q=ct.R16_SNORM_EXT)),_===i.RED_INTEGER&&(O===i.UNSIGNED_BYTE&&(q=i.R8UI),O===i.UNSIGNED_SHORT&&(q=i.R16UI),O===i.UNSIGNED_INT&&(q=i.R32UI),O===i.BYTE&&(q=i.R8I),O===i.SHORT&&(q=i.R16I),O===i.INT&&(q=i.R32I)),_===i.RG&&(O===i.FLOAT&&(q=i.RG32F),O===i.HALF_FLOAT&&(q=i.RG16F),O===i.UNSIGNED_BYTE&&(q=i.RG8),O===i.UNSIGNED_SHORT&&ct&&(q=ct.RG16_EXT),O===i.SHORT&&ct&&(q=ct.RG16_SNORM_EXT)),_===i.RG_INTEGER&&(O===i.UNSIGNED_BYTE&&(q=i.RG8UI),O===i.UNSIGNED_SHORT&&(q=i.RG16UI),O===i.UNSIGNED_INT&&(q=i.RG32UI),O===i.BYTE&&(q=i.RG8I),O===i.SHORT&&(q=i.RG16I),O===i.INT&&(q=i.RG32I)),_===i.RGB_INTEGER&&(O===i.UNSIGNED_BYTE&&(q=i.RGB8UI),O===i.UNSIGNED_SHORT&&(q=i.RGB16UI),O===i.UNSIGNED_INT&&(q=i.RGB32UI),O===i.BYTE&&(q=i.RGB8I),O===i.SHORT&&(q=i.RGB16I),O===i.INT&&(q=i.RGB32I)),_===i.RGBA_INTEGER&&(O===i.UNSIGNED_BYTE&&(q=i.RGBA8UI),O===i.UNSIGNED_SHORT&&(q=i.RGBA16UI),O===i.UNSIGNED_INT&&(q=i.RGBA32UI),O===i.BYTE&&(q=i.RGBA8I),O===i.SHORT&&(q=i.RGBA16I),O===i.INT&&(q=i.RGBA32I)),_===i.RGB&&(O===i.UNSIGNED_SHORT&&ct&&(q=ct.RGB16_EXT),O===i.SHORT&&ct&&(q=ct.RGB16_SNORM_EXT),O===i.UNSIGNED_INT_5_9_9_9_REV&&(q=i.RGB9_E5),O===i.UNSIGNED_INT_10F_11F_11F_REV&&(q=i.R11F_G11F_B10F)),_===i.RGBA){const $=st?Sa:qt.getTransfer(J);O===i.FLOAT&&(q=i.RGBA32F),O===i.HALF_FLOAT&&(q=i.RGBA16F),O===i.UNSIGNED_BYTE&&(q=$===ne?i.SRGB8_ALPHA8:i.RGBA8),O===i.UNSIGNED_SHORT&&ct&&(q=ct.RGBA16_EXT),O===i.SHORT&&ct&&(q=ct.RGBA16_SNORM_EXT),O===i.UNSIGNED_SHORT_4_4_4_4&&(q=i.RGBA4),O===i.UNSIGNED_SHORT_5_5_5_1&&(q=i.RGB5_A1)}return(q===i.R16F||q===i.R32F||q===i.RG16F||q===i.RG32F||q===i.RGBA16F||q===i.RGBA32F)&&t.get("EXT_color_buffer_float"),q}function v(b,_){let O;return b?_===null||_===ln||_===us?O=i.DEPTH24_STENCIL8:_===rn?O=i.DEPTH32F_STENCIL8:_===er&&(O=i.DEPTH24_STENCIL8,Pt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):_===null||_===ln||_===us?O=i.DEPTH_COMPONENT24:_===rn?O=i.DEPTH_COMPONENT32F:_===er&&(O=i.DEPTH_COMPONENT16),O}function y(b,_){return T(b)===!0||b.isFramebufferTexture&&b.minFilter!==xe&&b.minFilter!==Fe?Math.log2(Math.max(_.width,_.height))+1:b.mipmaps.length>0?b.mipmaps.length:b.isCompressedTexture&&Array.isArray(b.image)?_.mipmaps.length:1}function N(b){const _=new WeakRef(b);n.get(b).__ref=_,m.add(_),x.register(b,_,_)}function P(b){const _=n.get(b).__ref;_!==void 0&&(m.delete(_),x.unregister(_))}function D(b){W(b.target)}function B(b){C(b.target)}function W(b){b.removeEventListener("dispose",D),P(b),Z(b),b.isVideoTexture&&h.delete(b),b.isHTMLTexture&&u.delete(b)}function C(b){b.removeEventListener("dispose",B),P(b),et(b)}function H(){for(const b of m){const _=b.deref();_!==void 0&&(_.isRenderTarget===!0?C(_):W(_))}m.clear(),u.clear()}function Z(b){const _=n.get(b);if(_.__webglInit===void 0)return;const O=b.source,tt=f.get(O);if(tt){const J=tt[_.__cacheKey];J.usedTimes--,J.usedTimes===0&&G(b),Object.keys(tt).length===0&&f.delete(O)}n.remove(b)}function G(b){const _=n.get(b);i.deleteTexture(_.__webglTexture);const O=b.source,tt=f.get(O);delete tt[_.__cacheKey],a.memory.textures--}function et(b){const _=n.get(b);_.__depthDisposeCallback&&_.__depthDisposeCallback();const O=b.depthTexture;if(O&&O.renderTarget===b&&W(O),b.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(_.__webglFramebuffer[J]))for(let st=0;st<_.__webglFramebuffer[J].length;st++)i.deleteFramebuffer(_.__webglFramebuffer[J][st]);else i.deleteFramebuffer(_.__webglFramebuffer[J]);_.__webglDepthbuffer&&i.deleteRenderbuffer(_.__webglDepthbuffer[J])}else{if(Array.isArray(_.__webglFramebuffer))for(let J=0;J<_.__webglFramebuffer.length;J++)i.deleteFramebuffer(_.__webglFramebuffer[J]);else i.deleteFramebuffer(_.__webglFramebuffer);if(_.__webglDepthbuffer&&i.deleteRenderbuffer(_.__webglDepthbuffer),_.__webglMultisampledFramebuffer&&i.deleteFramebuffer(_.__webglMultisampledFramebuffer),_.__webglColorRenderbuffer)for(let J=0;J<_.__webglColorRenderbuffer.length;J++)_.__webglColorRenderbuffer[J]&&i.deleteRenderbuffer(_.__webglColorRenderbuffer[J]);_.__webglDepthRenderbuffer&&i.deleteRenderbuffer(_.__webglDepthRenderbuffer)}const tt=b.textures;for(let J=0,st=tt.length;J<st;J++){const ct=n.get(tt[J]);ct.__webglTexture&&(i.deleteTexture(ct.__webglTexture),a.memory.textures--),n.remove(tt[J])}n.remove(b)}let X=0;function Q(){X=0}function j(){return X}function Mt(b){X=b}function Nt(){const b=X;return b>=s.maxTextures&&Pt("WebGLTextures: Trying to use "+(b+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,b}function Y(b){const _=[];return _.push(b.wrapS),_.push(b.wrapT),_.push(b.wrapR||0),_.push(b.magFilter),_.push(b.minFilter),_.push(b.anisotropy),_.push(b.internalFormat),_.push(b.format),_.push(b.type),_.push(b.generateMipmaps),_.push(b.mipmapsAutoUpdate),_.push(b.premultiplyAlpha),_.push(b.flipY),_.push(b.unpackAlignment),_.push(b.colorSpace),_.join()}function pt(b,_){const O=n.get(b);if(b.isVideoTexture&&Se(b),b.isRenderTargetTexture===!1&&b.isExternalTexture!==!0&&b.version>0&&O.__version!==b.version){const tt=b.image;if(tt===null)Pt("WebGLRenderer: Texture marked for update but no image data found.");else if(tt.complete===!1)Pt("WebGLRenderer: Texture marked for update but image is incomplete");else{we(O,b,_);return}}else b.isExternalTexture&&(O.__webglTexture=b.sourceTexture?b.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,O.__webglTexture,i.TEXTURE0+_)}function xt(b,_){const O=n.get(b);if(b.isRenderTargetTexture===!1&&b.version>0&&O.__version!==b.version){we(O,b,_);return}else b.isExternalTexture&&(O.__webglTexture=b.sourceTexture?b.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,O.__webglTexture,i.TEXTURE0+_)}function Rt(b,_){const O=n.get(b);if(b.isRenderTargetTexture===!1&&b.version>0&&O.__version!==b.version){we(O,b,_);return}e.bindTexture(i.TEXTURE_3D,O.__webglTexture,i.TEXTURE0+_)}function gt(b,_){const O=n.get(b);if(b.version>0&&O.__version!==b.version){Ge(O,b,_);return}e.bindTexture(i.TEXTURE_CUBE_MAP,O.__webglTexture,i.TEXTURE0+_)}const Ft={[va]:i.REPEAT,[Jn]:i.CLAMP_TO_EDGE,[ul]:i.MIRRORED_REPEAT},pe={[xe]:i.NEAREST,[Am]:i.NEAREST_MIPMAP_NEAREST,[hr]:i.NEAREST_MIPMAP_LINEAR,[Fe]:i.LINEAR,[to]:i.LINEAR_MIPMAP_NEAREST,[ui]:i.LINEAR_MIPMAP_LINEAR},Lt={[Pm]:i.NEVER,[of]:i.ALWAYS,[Im]:i.LESS,[Rc]:i.LEQUAL,[Dm]:i.EQUAL,[af]:i.GEQUAL,[Nm]:i.GREATER,[Um]:i.NOTEQUAL};function te(b,_){if(_.type===rn&&t.has("OES_texture_float_linear")===!1&&(_.magFilter===Fe||_.magFilter===to||_.magFilter===hr||_.magFilter===ui||_.minFilter===Fe||_.minFilter===to||_.minFilter===hr||_.minFilter===ui)&&Pt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(b,i.TEXTURE_WRAP_S,Ft[_.wrapS]),i.texParameteri(b,i.TEXTURE_WRAP_T,Ft[_.wrapT]),(b===i.TEXTURE_3D||b===i.TEXTURE_2D_ARRAY)&&i.texParameteri(b,i.TEXTURE_WRAP_R,Ft[_.wrapR]),i.texParameteri(b,i.TEXTURE_MAG_FILTER,pe[_.magFilter]),i.texParameteri(b,i.TEXTURE_MIN_FILTER,pe[_.minFilter]),_.compareFunction&&(i.texParameteri(b,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(b,i.TEXTURE_COMPARE_FUNC,Lt[_.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(_.magFilter===xe||_.minFilter!==hr&&_.minFilter!==ui||_.type===rn&&t.has("OES_texture_float_linear")===!1)return;if(_.anisotropy>1||n.get(_).__currentAnisotropy){const O=t.get("EXT_texture_filter_anisotropic");i.texParameterf(b,O.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(_.anisotropy,s.getMaxAnisotropy())),n.get(_).__currentAnisotropy=_.anisotropy}}}function ie(b,_){let O=!1;b.__webglInit===void 0&&(b.__webglInit=!0,_.addEventListener("dispose",D),N(_));const tt=_.source;let J=f.get(tt);J===void 0&&(J={},f.set(tt,J));const st=Y(_);if(st!==b.__cacheKey){J[st]===void 0&&(J[st]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,O=!0),J[st].usedTimes++;const ct=J[b.__cacheKey];ct!==void 0&&(J[b.__cacheKey].usedTimes--,ct.usedTimes===0&&G(_)),b.__cacheKey=st,b.__webglTexture=J[st].texture}return O}function Ht(b,_,O){return Math.floor(Math.floor(b/O)/_)}function Ce(b,_,O,tt){const st=b.updateRanges;if(st.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,_.width,_.height,O,tt,_.data);else{st.sort((R,K)=>R.start-K.start);let ct=0;for(let R=1;R<st.length;R++){const K=st[ct],V=st[R],ot=K.start+K.count,it=Ht(V.start,_.width,4),rt=Ht(K.start,_.width,4);V.start<=ot+1&&it===rt&&Ht(V.start+V.count-1,_.width,4)===it?K.count=Math.max(K.count,V.start+V.count-K.start):(++ct,st[ct]=V)}st.length=ct+1;const q=e.getParameter(i.UNPACK_ROW_LENGTH),$=e.getParameter(i.UNPACK_SKIP_PIXELS),at=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,_.width);for(let R=0,K=st.length;R<K;R++){const V=st[R],ot=Math.floor(V.start/4),it=Math.ceil(V.count/4),rt=ot%_.width,Et=Math.floor(ot/_.width),Bt=it,nt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Et),e.texSubImage2D(i.TEXTURE_2D,0,rt,Et,Bt,nt,O,tt,_.data)}b.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,q),e.pixelStorei(i.UNPACK_SKIP_PIXELS,$),e.pixelStorei(i.UNPACK_SKIP_ROWS,at)}}function we(b,_,O){let tt=i.TEXTURE_2D;(_.isDataArrayTexture||_.isCompressedArrayTexture)&&(tt=i.TEXTURE_2D_ARRAY),_.isData3DTexture&&(tt=i.TEXTURE_3D);const J=ie(b,_),st=_.source;e.bindTexture(tt,b.__webglTexture,i.TEXTURE0+O);const ct=n.get(st);if(st.version!==ct.__version||J===!0){if(e.activeTexture(i.TEXTURE0+O),(typeof ImageBitmap<"u"&&_.image instanceof ImageBitmap)===!1){const nt=qt.getPrimaries(qt.workingColorSpace),Tt=_.colorSpace===qn?null:qt.getPrimaries(_.colorSpace),Ot=_.colorSpace===qn||nt===Tt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,_.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ot)}e.pixelStorei(i.UNPACK_ALIGNMENT,_.unpackAlignment);let $=S(_.image,!1,s.maxTextureSize);$=Ct(_,$);const at=r.convert(_.format,_.colorSpace),R=r.convert(_.type);let K=E(_.internalFormat,at,R,_.normalized,_.colorSpace,_.isVideoTexture);te(tt,_);let V;const ot=_.mipmaps,it=_.isVideoTexture!==!0,rt=ct.__version===void 0||J===!0,Et=st.dataReady,Bt=y(_,$);if(_.isDepthTexture)K=v(_.format===di,_.type),rt&&(it?e.texStorage2D(i.TEXTURE_2D,1,K,$.width,$.height):e.texImage2D(i.TEXTURE_2D,0,K,$.width,$.height,0,at,R,null));else if(_.isDataTexture)if(ot.length>0){it&&rt&&e.texStorage2D(i.TEXTURE_2D,Bt,K,ot[0].width,ot[0].height);for(let nt=0,Tt=ot.length;nt<Tt;nt++)V=ot[nt],it?Et&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,V.width,V.height,at,R,V.data):e.texImage2D(i.TEXTURE_2D,nt,K,V.width,V.height,0,at,R,V.data);_.generateMipmaps=!1}else it?(rt&&e.texStorage2D(i.TEXTURE_2D,Bt,K,$.width,$.height),Et&&Ce(_,$,at,R)):e.texImage2D(i.TEXTURE_2D,0,K,$.width,$.height,0,at,R,$.data);else if(_.isCompressedTexture)if(_.isCompressedArrayTexture){it&&rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Bt,K,ot[0].width,ot[0].height,$.depth);for(let nt=0,Tt=ot.length;nt<Tt;nt++)if(V=ot[nt],_.format!==an)if(at!==null)if(it){if(Et)if(_.layerUpdates.size>0){const Ot=$h(V.width,V.height,_.format,_.type);for(const dt of _.layerUpdates){const ee=V.data.subarray(dt*Ot/V.data.BYTES_PER_ELEMENT,(dt+1)*Ot/V.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,dt,V.width,V.height,1,at,ee)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,V.width,V.height,$.depth,at,V.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,nt,K,V.width,V.height,$.depth,0,V.data,0,0);else Pt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else it?Et&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,V.width,V.height,$.depth,at,R,V.data):e.texImage3D(i.TEXTURE_2D_ARRAY,nt,K,V.width,V.height,$.depth,0,at,R,V.data);_.layerUpdates.size>0&&_.clearLayerUpdates()}else{it&&rt&&e.texStorage2D(i.TEXTURE_2D,Bt,K,ot[0].width,ot[0].height);for(let nt=0,Tt=ot.length;nt<Tt;nt++)V=ot[nt],_.format!==an?at!==null?it?Et&&e.compressedTexSubImage2D(i.TEXTURE_2D,nt,0,0,V.width,V.height,at,V.data):e.compressedTexImage2D(i.TEXTURE_2D,nt,K,V.width,V.height,0,V.data):Pt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):it?Et&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,V.width,V.height,at,R,V.data):e.texImage2D(i.TEXTURE_2D,nt,K,V.width,V.height,0,at,R,V.data)}else if(_.isDataArrayTexture)if(it){if(rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Bt,K,$.width,$.height,$.depth),Et)if(_.layerUpdates.size>0){const nt=$h($.width,$.height,_.format,_.type);for(const Tt of _.layerUpdates){const Ot=$.data.subarray(Tt*nt/$.data.BYTES_PER_ELEMENT,(Tt+1)*nt/$.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Tt,$.width,$.height,1,at,R,Ot)}_.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,$.width,$.height,$.depth,at,R,$.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,K,$.width,$.height,$.depth,0,at,R,$.data);else if(_.isData3DTexture)it?(rt&&e.texStorage3D(i.TEXTURE_3D,Bt,K,$.width,$.height,$.depth),Et&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,$.width,$.height,$.depth,at,R,$.data)):e.texImage3D(i.TEXTURE_3D,0,K,$.width,$.height,$.depth,0,at,R,$.data);else if(_.isFramebufferTexture){if(rt)if(it)e.texStorage2D(i.TEXTURE_2D,Bt,K,$.width,$.height);else{let nt=$.width,Tt=$.height;for(let Ot=0;Ot<Bt;Ot++)e.texImage2D(i.TEXTURE_2D,Ot,K,nt,Tt,0,at,R,null),nt>>=1,Tt>>=1}}else if(_.isHTMLTexture){if("texElementImage2D"in i){const nt=i.canvas;if(nt.hasAttribute("layoutsubtree")||nt.setAttribute("layoutsubtree","true"),$.parentNode!==nt){nt.appendChild($),u.add(_),nt.onpaint=Tt=>{const Ot=Tt.changedElements;for(const dt of u)Ot.includes(dt.image)&&(dt.needsUpdate=!0)},nt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,$);else{const Ot=i.RGBA,dt=i.RGBA,ee=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Ot,dt,ee,$)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(ot.length>0){if(it&&rt){const nt=It(ot[0]);e.texStorage2D(i.TEXTURE_2D,Bt,K,nt.width,nt.height)}for(let nt=0,Tt=ot.length;nt<Tt;nt++)V=ot[nt],it?Et&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,at,R,V):e.texImage2D(i.TEXTURE_2D,nt,K,at,R,V);_.generateMipmaps=!1}else if(it){if(rt){const nt=It($);e.texStorage2D(i.TEXTURE_2D,Bt,K,nt.width,nt.height)}Et&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,at,R,$)}else e.texImage2D(i.TEXTURE_2D,0,K,at,R,$);T(_)&&_.mipmapsAutoUpdate===!0&&M(tt),ct.__version=st.version,_.onUpdate&&_.onUpdate(_)}b.__version=_.version}function Ge(b,_,O){if(_.image.length!==6)return;const tt=ie(b,_),J=_.source;e.bindTexture(i.TEXTURE_CUBE_MAP,b.__webglTexture,i.TEXTURE0+O);const st=n.get(J);if(J.version!==st.__version||tt===!0){e.activeTexture(i.TEXTURE0+O);const ct=qt.getPrimaries(qt.workingColorSpace),q=_.colorSpace===qn?null:qt.getPrimaries(_.colorSpace),$=_.colorSpace===qn||ct===q?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,_.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,_.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,$);const at=_.isCompressedTexture||_.image[0].isCompressedTexture,R=_.image[0]&&_.image[0].isDataTexture,K=[];for(let dt=0;dt<6;dt++)!at&&!R?K[dt]=S(_.image[dt],!0,s.maxCubemapSize):K[dt]=R?_.image[dt].image:_.image[dt],K[dt]=Ct(_,K[dt]);const V=K[0],ot=r.convert(_.format,_.colorSpace),it=r.convert(_.type);let rt=E(_.internalFormat,ot,it,_.normalized,_.colorSpace);const Et=_.isVideoTexture!==!0,Bt=st.__version===void 0||tt===!0,nt=J.dataReady;let Tt=y(_,V);te(i.TEXTURE_CUBE_MAP,_);let Ot;if(_.isDepthTexture){if(rt=v(_.format===di,_.type),Bt)if(Et)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,rt,V.width,V.height);else for(let dt=0;dt<6;dt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,V.width,V.height,0,ot,it,null)}else if(at){Et&&Bt&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Tt,rt,V.width,V.height);for(let dt=0;dt<6;dt++){Ot=K[dt].mipmaps;for(let ee=0;ee<Ot.length;ee++){const be=Ot[ee];_.format!==an?ot!==null?Et?nt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee,0,0,be.width,be.height,ot,be.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee,rt,be.width,be.height,0,be.data):Pt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Et?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee,0,0,be.width,be.height,ot,it,be.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee,rt,be.width,be.height,0,ot,it,be.data)}}}else{if(Ot=_.mipmaps,Et&&Bt){Ot.length>0&&Tt++;const dt=It(K[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Tt,rt,dt.width,dt.height)}for(let dt=0;dt<6;dt++)if(R){Et?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,0,0,K[dt].width,K[dt].height,ot,it,K[dt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,K[dt].width,K[dt].height,0,ot,it,K[dt].data);for(let ee=0;ee<Ot.length;ee++){const ei=Ot[ee].image[dt].image;Et?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee+1,0,0,ei.width,ei.height,ot,it,ei.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee+1,rt,ei.width,ei.height,0,ot,it,ei.data)}}else{Et?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,0,0,ot,it,K[dt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,ot,it,K[dt]);for(let ee=0;ee<Ot.length;ee++){const be=Ot[ee];Et?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee+1,0,0,ot,it,be.image[dt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,ee+1,rt,ot,it,be.image[dt])}}}T(_)&&_.mipmapsAutoUpdate===!0&&M(i.TEXTURE_CUBE_MAP),st.__version=J.version,_.onUpdate&&_.onUpdate(_)}b.__version=_.version}function he(b,_,O,tt,J,st){const ct=r.convert(O.format,O.colorSpace),q=r.convert(O.type),$=E(O.internalFormat,ct,q,O.normalized,O.colorSpace),at=n.get(_),R=n.get(O);if(R.__renderTarget=_,!at.__hasExternalTextures){const K=Math.max(1,_.width>>st),V=Math.max(1,_.height>>st);J===i.TEXTURE_3D||J===i.TEXTURE_2D_ARRAY?e.texImage3D(J,st,$,K,V,_.depth,0,ct,q,null):e.texImage2D(J,st,$,K,V,0,ct,q,null)}e.bindFramebuffer(i.FRAMEBUFFER,b),ut(_)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,tt,J,R.__webglTexture,0,ce(_)):(J===i.TEXTURE_2D||J>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&J<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,tt,J,R.__webglTexture,st),e.bindFramebuffer(i.FRAMEBUFFER,null)}function wn(b,_,O){if(i.bindRenderbuffer(i.RENDERBUFFER,b),_.depthBuffer){const tt=_.depthTexture,J=tt&&tt.isDepthTexture?tt.type:null,st=v(_.stencilBuffer,J),ct=_.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;ut(_)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ce(_),st,_.width,_.height):O?i.renderbufferStorageMultisample(i.RENDERBUFFER,ce(_),st,_.width,_.height):i.renderbufferStorage(i.RENDERBUFFER,st,_.width,_.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ct,i.RENDERBUFFER,b)}else{const tt=_.textures;for(let J=0;J<tt.length;J++){const st=tt[J],ct=r.convert(st.format,st.colorSpace),q=r.convert(st.type),$=E(st.internalFormat,ct,q,st.normalized,st.colorSpace);ut(_)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ce(_),$,_.width,_.height):O?i.renderbufferStorageMultisample(i.RENDERBUFFER,ce(_),$,_.width,_.height):i.renderbufferStorage(i.RENDERBUFFER,$,_.width,_.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Ee(b,_,O){const tt=_.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,b),!(_.depthTexture&&_.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");const J=n.get(_.depthTexture);J.__renderTarget=_;const st=tt?_.depthTexture.image[0]:_.depthTexture.image;(!J.__webglTexture||st.width!==_.width||st.height!==_.height)&&(st.width=_.width,st.height=_.height,_.depthTexture.needsUpdate=!0),tt?gt(_.depthTexture,0):pt(_.depthTexture,0);const ct=J.__webglTexture,q=ce(_),$=tt?i.TEXTURE_CUBE_MAP_POSITIVE_X+O:i.TEXTURE_2D,at=_.depthTexture.format===di?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(_.depthTexture.format===gi)ut(_)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,$,ct,0,q):i.framebufferTexture2D(i.FRAMEBUFFER,at,$,ct,0);else if(_.depthTexture.format===di)ut(_)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,$,ct,0,q):i.framebufferTexture2D(i.FRAMEBUFFER,at,$,ct,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Ze(b){const _=n.get(b),O=b.isWebGLCubeRenderTarget===!0;if(_.__boundDepthTexture!==b.depthTexture){const tt=b.depthTexture;if(_.__depthDisposeCallback&&_.__depthDisposeCallback(),tt){const J=()=>{delete _.__boundDepthTexture,delete _.__depthDisposeCallback,tt.removeEventListener("dispose",J)};tt.addEventListener("dispose",J),_.__depthDisposeCallback=J}_.__boundDepthTexture=tt}if(b.depthTexture&&!_.__autoAllocateDepthBuffer)if(O)for(let tt=0;tt<6;tt++)Ee(_.__webglFramebuffer[tt],b,tt);else b.texture.mipmaps.length>0?Ee(_.__webglFramebuffer[0],b,0):Ee(_.__webglFramebuffer,b,0);else if(O){_.__webglDepthbuffer=[];for(let tt=0;tt<6;tt++)if(e.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer[tt]),_.__webglDepthbuffer[tt]===void 0)_.__webglDepthbuffer[tt]=i.createRenderbuffer(),wn(_.__webglDepthbuffer[tt],b,!1);else{const J=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=_.__webglDepthbuffer[tt];i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,J,i.RENDERBUFFER,st)}}else if(b.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer),_.__webglDepthbuffer===void 0)_.__webglDepthbuffer=i.createRenderbuffer(),wn(_.__webglDepthbuffer,b,!1);else{const J=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=_.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,J,i.RENDERBUFFER,st)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Je(b,_,O){const tt=n.get(b);_!==void 0&&he(tt.__webglFramebuffer,b,b.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),O!==void 0&&Ze(b)}function Qe(b){const _=b.texture,O=n.get(b),tt=n.get(_);b.addEventListener("dispose",B),N(b);const J=b.textures,st=b.isWebGLCubeRenderTarget===!0,ct=J.length>1;if(ct||(tt.__webglTexture===void 0&&(tt.__webglTexture=i.createTexture()),tt.__version=_.version,a.memory.textures++),st){O.__webglFramebuffer=[];for(let q=0;q<6;q++)if(_.mipmaps.length>0){O.__webglFramebuffer[q]=[];for(let $=0;$<_.mipmaps.length;$++)O.__webglFramebuffer[q][$]=i.createFramebuffer()}else O.__webglFramebuffer[q]=i.createFramebuffer()}else{if(_.mipmaps.length>0){O.__webglFramebuffer=[];for(let q=0;q<_.mipmaps.length;q++)O.__webglFramebuffer[q]=i.createFramebuffer()}else O.__webglFramebuffer=i.createFramebuffer();if(ct)for(let q=0,$=J.length;q<$;q++){const at=n.get(J[q]);at.__webglTexture===void 0&&(at.__webglTexture=i.createTexture(),a.memory.textures++)}if(b.samples>0&&ut(b)===!1){O.__webglMultisampledFramebuffer=i.createFramebuffer(),O.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,O.__webglMultisampledFramebuffer);for(let q=0;q<J.length;q++){const $=J[q];O.__webglColorRenderbuffer[q]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,O.__webglColorRenderbuffer[q]);const at=r.convert($.format,$.colorSpace),R=r.convert($.type),K=E($.internalFormat,at,R,$.normalized,$.colorSpace,b.isXRRenderTarget===!0),V=ce(b);i.renderbufferStorageMultisample(i.RENDERBUFFER,V,K,b.width,b.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+q,i.RENDERBUFFER,O.__webglColorRenderbuffer[q])}i.bindRenderbuffer(i.RENDERBUFFER,null),b.depthBuffer&&(O.__webglDepthRenderbuffer=i.createRenderbuffer(),wn(O.__webglDepthRenderbuffer,b,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(st){e.bindTexture(i.TEXTURE_CUBE_MAP,tt.__webglTexture),te(i.TEXTURE_CUBE_MAP,_);for(let q=0;q<6;q++)if(_.mipmaps.length>0)for(let $=0;$<_.mipmaps.length;$++)he(O.__webglFramebuffer[q][$],b,_,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+q,$);else he(O.__webglFramebuffer[q],b,_,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+q,0);T(_)?M(i.TEXTURE_CUBE_MAP):_.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,_.mipmaps.length-1),e.unbindTexture()}else if(ct){for(let q=0,$=J.length;q<$;q++){const at=J[q],R=n.get(at);let K=i.TEXTURE_2D;(b.isWebGL3DRenderTarget||b.isWebGLArrayRenderTarget)&&(K=b.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(K,R.__webglTexture),te(K,at),he(O.__webglFramebuffer,b,at,i.COLOR_ATTACHMENT0+q,K,0),T(at)&&M(K)}e.unbindTexture()}else{let q=i.TEXTURE_2D;if((b.isWebGL3DRenderTarget||b.isWebGLArrayRenderTarget)&&(q=b.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(q,tt.__webglTexture),te(q,_),_.mipmaps.length>0)for(let $=0;$<_.mipmaps.length;$++)he(O.__webglFramebuffer[$],b,_,i.COLOR_ATTACHMENT0,q,$);else he(O.__webglFramebuffer,b,_,i.COLOR_ATTACHMENT0,q,0);T(_)?M(q):_.mipmaps.length>0&&i.texParameteri(q,i.TEXTURE_MAX_LEVEL,_.mipmaps.length-1),e.unbindTexture()}b.depthBuffer&&Ze(b)}function I(b){const _=b.textures;for(let O=0,tt=_.length;O<tt;O++){const J=_[O];if(T(J)&&J.mipmapsAutoUpdate===!0){const st=A(b),ct=n.get(J).__webglTexture;e.bindTexture(st,ct),M(st),e.unbindTexture()}}}const je=[];function le(b){if(b.samples>0){if(ut(b)===!1){const _=b.textures,O=b.width,tt=b.height;let J=i.COLOR_BUFFER_BIT;const st=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ct=n.get(b),q=_.length>1;if(q)for(let at=0;at<_.length;at++)e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,ct.__webglMultisampledFramebuffer),b.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer);for(let at=0;at<_.length;at++){if(b.resolveDepthBuffer&&(b.depthBuffer&&(J|=i.DEPTH_BUFFER_BIT),b.stencilBuffer&&b.resolveStencilBuffer&&(J|=i.STENCIL_BUFFER_BIT)),q){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ct.__webglColorRenderbuffer[at]);const R=n.get(_[at]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,R,0)}i.blitFramebuffer(0,0,O,tt,0,0,O,tt,J,i.NEAREST),l===!0&&(je.length=0,je.push(i.COLOR_ATTACHMENT0+at),b.depthBuffer&&b.storeMultisampledDepthBuffer===!1&&je.push(st),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,je))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),q)for(let at=0;at<_.length;at++){e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,ct.__webglColorRenderbuffer[at]);const R=n.get(_[at]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,R,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglMultisampledFramebuffer)}else if(b.depthBuffer&&b.storeMultisampledDepthBuffer===!1&&l){const _=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[_])}}}function ce(b){return Math.min(s.maxSamples,b.samples)}function ut(b){const _=n.get(b);return b.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&_.__useRenderToTexture!==!1}function Se(b){const _=a.render.frame;h.get(b)!==_&&(h.set(b,_),b.update())}function Ct(b,_){const O=b.colorSpace,tt=b.format,J=b.type;return b.isCompressedTexture===!0||b.isVideoTexture===!0||O!==wa&&O!==qn&&(qt.getTransfer(O)===ne?(tt!==an||J!==sn)&&Pt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Jt("WebGLTextures: Unsupported texture color space:",O)),_}function It(b){return typeof HTMLImageElement<"u"&&b instanceof HTMLImageElement?(c.width=b.naturalWidth||b.width,c.height=b.naturalHeight||b.height):typeof VideoFrame<"u"&&b instanceof VideoFrame?(c.width=b.displayWidth,c.height=b.displayHeight):(c.width=b.width,c.height=b.height),c}this.allocateTextureUnit=Nt,this.resetTextureUnits=Q,this.getTextureUnits=j,this.setTextureUnits=Mt,this.setTexture2D=pt,this.setTexture2DArray=xt,this.setTexture3D=Rt,this.setTextureCube=gt,this.rebindTextures=Je,this.setupRenderTarget=Qe,this.updateRenderTargetMipmap=I,this.updateMultisampleRenderTarget=le,this.setupDepthRenderbuffer=Ze,this.setupFrameBufferTexture=he,this.useMultisampledRTT=ut,this.dispose=H}function lw(i,t){function e(n,s=qn){let r;const a=qt.getTransfer(s);if(n===sn)return i.UNSIGNED_BYTE;if(n===Ec)return i.UNSIGNED_SHORT_4_4_4_4;if(n===bc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===tf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===ef)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Qd)return i.BYTE;if(n===jd)return i.SHORT;if(n===er)return i.UNSIGNED_SHORT;if(n===yc)return i.INT;if(n===ln)return i.UNSIGNED_INT;if(n===rn)return i.FLOAT;if(n===xn)return i.HALF_FLOAT;if(n===nf)return i.ALPHA;if(n===sf)return i.RGB;if(n===an)return i.RGBA;if(n===gi)return i.DEPTH_COMPONENT;if(n===di)return i.DEPTH_STENCIL;if(n===rf)return i.RED;if(n===Tc)return i.RED_INTEGER;if(n===vi)return i.RG;if(n===za)return i.RG_INTEGER;if(n===Ac)return i.RGBA_INTEGER;if(n===na||n===ia||n===sa||n===ra)if(a===ne)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===na)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ia)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===sa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===ra)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===na)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ia)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===sa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===ra)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===dl||n===fl||n===pl||n===ml)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===dl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===fl)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===pl)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ml)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===gl||n===vl||n===_l||n===xl||n===wl||n===_a||n===Sl)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===gl||n===vl)return a===ne?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===_l)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===xl)return r.COMPRESSED_R11_EAC;if(n===wl)return r.COMPRESSED_SIGNED_R11_EAC;if(n===_a)return r.COMPRESSED_RG11_EAC;if(n===Sl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Ml||n===yl||n===El||n===bl||n===Tl||n===Al||n===Rl||n===Cl||n===Ll||n===Pl||n===Il||n===Dl||n===Nl||n===Ul)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Ml)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===yl)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===El)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===bl)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Tl)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Al)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Rl)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Cl)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Ll)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Pl)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Il)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Dl)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Nl)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Ul)return a===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Fl||n===Ol||n===kl)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Fl)return a===ne?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Ol)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===kl)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Bl||n===zl||n===xa||n===Gl)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Bl)return r.COMPRESSED_RED_RGTC1_EXT;if(n===zl)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===xa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Gl)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===us?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}const cw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,hw=`
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

}`;class uw{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){const n=new gf(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){const e=t.cameras[0].viewport,n=new Bi({vertexShader:cw,fragmentShader:hw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Nn(new Va(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class dw extends Gi{constructor(t,e){super();const n=this;let s=null,r=1,a=null,o="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,m=null;const x=typeof XRWebGLBinding<"u",g=new uw,p={},S=e.getContextAttributes();let T=null,M=null;const A=[],E=[],v=new Kt;let y=null,N=null;const P=new pn;P.viewport=new de;const D=new pn;D.viewport=new de;const B=[P,D],W=new E0;let C=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Y){let pt=A[Y];return pt===void 0&&(pt=new co,A[Y]=pt),pt.getTargetRaySpace()},this.getControllerGrip=function(Y){let pt=A[Y];return pt===void 0&&(pt=new co,A[Y]=pt),pt.getGripSpace()},this.getHand=function(Y){let pt=A[Y];return pt===void 0&&(pt=new co,A[Y]=pt),pt.getHandSpace()};function Z(Y){const pt=E.indexOf(Y.inputSource);if(pt===-1)return;const xt=A[pt];xt!==void 0&&(xt.update(Y.inputSource,Y.frame,c||a),xt.dispatchEvent({type:Y.type,data:Y.inputSource}))}function G(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",et);for(let Y=0;Y<A.length;Y++){const pt=E[Y];pt!==null&&(E[Y]=null,A[Y].disconnect(pt))}C=null,H=null,g.reset();for(const Y in p)delete p[Y];if(t.setRenderTarget(T),f=null,d=null,u=null,s=null,M=null,Nt.stop(),n.isPresenting=!1,t.setPixelRatio(y),t.setSize(v.width,v.height,!1),N!==null){const Y=N.camera;Y.fov=N.fov,Y.zoom=N.zoom,Y.updateProjectionMatrix(),N=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Y){r=Y,n.isPresenting===!0&&Pt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Y){o=Y,n.isPresenting===!0&&Pt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(Y){c=Y},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(Y){if(s=Y,s!==null){if(T=t.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",G),s.addEventListener("inputsourceschange",et),S.xrCompatible!==!0&&await e.makeXRCompatible(),y=t.getPixelRatio(),t.getSize(v),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,Rt=null,gt=null;S.depth&&(gt=S.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=S.stencil?di:gi,Rt=S.stencil?us:ln);const Ft={colorFormat:e.RGBA8,depthFormat:gt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Ft),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),M=new _n(d.textureWidth,d.textureHeight,{format:an,type:sn,depthTexture:new ki(d.textureWidth,d.textureHeight,Rt,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:S.stencil,colorSpace:t.outputColorSpace,samples:S.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{const xt={antialias:S.antialias,alpha:!0,depth:S.depth,stencil:S.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),M=new _n(f.framebufferWidth,f.framebufferHeight,{format:an,type:sn,colorSpace:t.outputColorSpace,stencilBuffer:S.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),Nt.setContext(s),Nt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function et(Y){for(let pt=0;pt<Y.removed.length;pt++){const xt=Y.removed[pt],Rt=E.indexOf(xt);Rt>=0&&(E[Rt]=null,A[Rt].disconnect(xt))}for(let pt=0;pt<Y.added.length;pt++){const xt=Y.added[pt];let Rt=E.indexOf(xt);if(Rt===-1){for(let Ft=0;Ft<A.length;Ft++)if(Ft>=E.length){E.push(xt),Rt=Ft;break}else if(E[Ft]===null){E[Ft]=xt,Rt=Ft;break}if(Rt===-1)break}const gt=A[Rt];gt&&gt.connect(xt)}}function X(Y,pt){pt===null?Y.matrixWorld.copy(Y.matrix):Y.matrixWorld.multiplyMatrices(pt.matrixWorld,Y.matrix),Y.matrixWorldInverse.copy(Y.matrixWorld).invert()}this.updateCamera=function(Y){if(s===null)return;let pt=Y.near,xt=Y.far;g.texture!==null&&(g.depthNear>0&&(pt=g.depthNear),g.depthFar>0&&(xt=g.depthFar)),W.near=D.near=P.near=pt,W.far=D.far=P.far=xt,(C!==W.near||H!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),C=W.near,H=W.far),W.layers.mask=Y.layers.mask|6,P.layers.mask=W.layers.mask&-5,D.layers.mask=W.layers.mask&-3;const Rt=Y.parent,gt=W.cameras;X(W,Rt);for(let Ft=0;Ft<gt.length;Ft++)X(gt[Ft],Rt);W.projectionMatrix.copy(P.projectionMatrix),W.projectionMatrixInverse.copy(P.projectionMatrixInverse),N===null&&Y.isPerspectiveCamera&&(N={camera:Y,fov:Y.fov,zoom:Y.zoom}),Q(Y,W,Rt)};function Q(Y,pt,xt){xt===null?Y.matrix.copy(pt.matrixWorld):(Y.matrix.copy(xt.matrixWorld),Y.matrix.invert(),Y.matrix.multiply(pt.matrixWorld)),Y.matrix.decompose(Y.position,Y.quaternion,Y.scale),Y.updateMatrixWorld(!0),Y.projectionMatrix.copy(pt.projectionMatrix),Y.projectionMatrixInverse.copy(pt.projectionMatrixInverse),Y.isPerspectiveCamera&&(Y.fov=Hl*2*Math.atan(1/Y.projectionMatrix.elements[5]),Y.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Y){l=Y,d!==null&&(d.fixedFoveation=Y),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Y)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(W)},this.getCameraTexture=function(Y){return p[Y]};let j=null;function Mt(Y,pt){if(h=pt.getViewerPose(c||a),m=pt,h!==null){const xt=h.views;f!==null&&(t.setRenderTargetFramebuffer(M,f.framebuffer),t.setRenderTarget(M));let Rt=!1;xt.length!==W.cameras.length&&(W.cameras.length=0,Rt=!0);for(let Lt=0;Lt<xt.length;Lt++){const te=xt[Lt];let ie=null;if(f!==null)ie=f.getViewport(te);else{const Ce=u.getViewSubImage(d,te);ie=Ce.viewport,Lt===0&&(t.setRenderTargetTextures(M,Ce.colorTexture,Ce.depthStencilTexture),t.setRenderTarget(M))}let Ht=B[Lt];Ht===void 0&&(Ht=new pn,Ht.layers.enable(Lt),Ht.viewport=new de,B[Lt]=Ht),Ht.matrix.fromArray(te.transform.matrix),Ht.matrix.decompose(Ht.position,Ht.quaternion,Ht.scale),Ht.projectionMatrix.fromArray(te.projectionMatrix),Ht.projectionMatrixInverse.copy(Ht.projectionMatrix).invert(),Ht.viewport.set(ie.x,ie.y,ie.width,ie.height),Lt===0&&(W.matrix.copy(Ht.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Rt===!0&&W.cameras.push(Ht)}const gt=s.enabledFeatures;if(gt&&gt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=n.getBinding();const Lt=u.getDepthInformation(xt[0]);Lt&&Lt.isValid&&Lt.texture&&g.init(Lt,s.renderState)}if(gt&&gt.includes("camera-access")&&x){t.state.unbindTexture(),u=n.getBinding();for(let Lt=0;Lt<xt.length;Lt++){const te=xt[Lt].camera;if(te){let ie=p[te];ie||(ie=new gf,p[te]=ie);const Ht=u.getCameraImage(te);ie.sourceTexture=Ht}}}}for(let xt=0;xt<A.length;xt++){const Rt=E[xt],gt=A[xt];Rt!==null&&gt!==void 0&&gt.update(Rt,pt,c||a)}j&&j(Y,pt),pt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:pt}),m=null}const Nt=new xf;Nt.setAnimationLoop(Mt),this.setAnimationLoop=function(Y){j=Y},this.dispose=function(){}}}const fw=new Qt,Cf=new Dt;Cf.set(-1,0,0,0,1,0,0,0,1);function pw(i,t){function e(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function n(g,p){p.color.getRGB(g.fogColor.value,vf(i)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function s(g,p,S,T,M){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(g,p):p.isMeshLambertMaterial?(r(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(g,p),u(g,p)):p.isMeshPhongMaterial?(r(g,p),h(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(g,p),d(g,p),p.isMeshPhysicalMaterial&&f(g,p,M)):p.isMeshMatcapMaterial?(r(g,p),m(g,p)):p.isMeshDepthMaterial?r(g,p):p.isMeshDistanceMaterial?(r(g,p),x(g,p)):p.isMeshNormalMaterial?r(g,p):p.isLineBasicMaterial?(a(g,p),p.isLineDashedMaterial&&o(g,p)):p.isPointsMaterial?l(g,p,S,T):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,e(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===Ve&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,e(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===Ve&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,e(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,e(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);const S=t.get(p),T=S.envMap,M=S.envMapRotation;T&&(g.envMap.value=T,g.envMapRotation.value.setFromMatrix4(fw.makeRotationFromEuler(M)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Cf),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,g.aoMapTransform))}function a(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform))}function o(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,S,T){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*S,g.scale.value=T*.5,p.map&&(g.map.value=p.map,e(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function h(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function u(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function d(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function f(g,p,S){g.ior.value=p.ior,p.diffuseRoughness>0&&(g.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Ve&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.retroreflectivity>0&&(g.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=S.texture,g.transmissionSamplerSize.value.set(S.width,S.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function x(g,p){const S=t.get(p).light;g.referencePosition.value.setFromMatrixPosition(S.matrixWorld),g.nearDistance.value=S.shadow.camera.near,g.farDistance.value=S.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function mw(i,t,e,n){let s={},r={};function a(S,T){const M=T.program;n.uniformBlockBinding(S,M,s[S.id])}function o(S,T){let M=s[S.id];M===void 0&&(m(S),M=l(S),s[S.id]=M,S.addEventListener("dispose",g));const A=T.program;n.updateUBOMapping(S,A);const E=t.render.frame;r[S.id]!==E&&(c(S),r[S.id]=E)}function l(S){const T=i.createBuffer(),M=S.__size,A=S.usage;return i.bindBuffer(i.UNIFORM_BUFFER,T),i.bufferData(i.UNIFORM_BUFFER,M,A),i.bindBuffer(i.UNIFORM_BUFFER,null),T}function c(S){const T=s[S.id],M=S.uniforms,A=S.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let E=0,v=M.length;E<v;E++){const y=M[E];if(Array.isArray(y))for(let N=0,P=y.length;N<P;N++)h(y[N],E,N,A);else h(y,E,0,A)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(S,T,M,A){if(d(S,T,M,A)===!0){const E=S.__offset,v=S.value;if(Array.isArray(v)){let y=0;for(let N=0;N<v.length;N++){const P=v[N],D=x(P,!0);u(P,S.__data,y),y+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(v,S.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,S.__data)}}function u(S,T,M){typeof S=="number"||typeof S=="boolean"?T[M]=S:S.isMatrix3?(T[M]=S.elements[0],T[M+1]=S.elements[1],T[M+2]=S.elements[2],T[M+3]=0,T[M+4]=S.elements[3],T[M+5]=S.elements[4],T[M+6]=S.elements[5],T[M+7]=0,T[M+8]=S.elements[6],T[M+9]=S.elements[7],T[M+10]=S.elements[8],T[M+11]=0):ArrayBuffer.isView(S)?T.set(S.subarray(0,T.length-M),M):S.toArray(T,M)}function d(S,T,M,A){const E=S.value,v=T+"_"+M;if(Array.isArray(E)){A[v]===void 0&&(A[v]=[]);const y=A[v];let N=!1;for(let P=0;P<E.length;P++)f(E[P],y,P)===!0&&(N=!0);return N}return f(E,A,v)}function f(S,T,M){if(T[M]===void 0)return typeof S=="number"||typeof S=="boolean"?T[M]=S:ArrayBuffer.isView(S)?T[M]=S.slice():T[M]=S.clone(),!0;{const A=T[M];if(typeof S=="number"||typeof S=="boolean"){if(A!==S)return T[M]=S,!0}else{if(ArrayBuffer.isView(S))return!0;if(A.equals(S)===!1)return A.copy(S),!0}}return!1}function m(S){const T=S.uniforms;let M=0;const A=16;for(let v=0,y=T.length;v<y;v++){const N=Array.isArray(T[v])?T[v]:[T[v]];for(let P=0,D=N.length;P<D;P++){const B=N[P],W=Array.isArray(B.value)?B.value:[B.value],C=Array.isArray(T[v])||Array.isArray(B.value);let H=M;for(let G=0,et=W.length;G<et;G++){const X=W[G],Q=x(X,C),j=M%A,Mt=j%Q.boundary,Nt=j+Mt;M+=Mt,Nt!==0&&A-Nt<Q.storage&&(M+=A-Nt),G===0&&(H=M),M+=Q.storage}const Z=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new Z((M-H)/Float32Array.BYTES_PER_ELEMENT),B.__offset=H}}const E=M%A;return E>0&&(M+=A-E),S.__size=M,S.__cache={},this}function x(S,T){const M={boundary:0,storage:0};return typeof S=="number"||typeof S=="boolean"?(M.boundary=4,M.storage=4):S.isVector2?(M.boundary=8,M.storage=8):S.isVector3||S.isColor?(M.boundary=16,M.storage=12):S.isVector4?(M.boundary=16,M.storage=16):S.isMatrix3?(M.boundary=16,M.storage=48):S.isMatrix4?(M.boundary=16,M.storage=64):S.isTexture?Pt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(S)?(M.boundary=16,M.storage=S.byteLength):Pt("WebGLRenderer: Unsupported uniform value type.",S),T===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function g(S){const T=S.target;T.removeEventListener("dispose",g),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function p(){for(const S in s)i.deleteBuffer(s[S]);s={},r={}}return{bind:a,update:o,dispose:p}}const gw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]);let Mn=null;function vw(){return Mn===null&&(Mn=new Ha(gw,16,16,vi,xn),Mn.name="DFG_LUT",Mn.minFilter=Fe,Mn.magFilter=Fe,Mn.wrapS=Jn,Mn.wrapT=Jn,Mn.generateMipmaps=!1,Mn.needsUpdate=!0),Mn}class _w{constructor(t={}){const{canvas:e=km(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=sn}=t;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=a;const x=f,g=new Set([Ac,za,Tc]),p=new Set([sn,ln,er,us,Ec,bc]),S=new Uint32Array(4),T=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]};let A=null,E=null;const v=[],y=[];let N=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Qn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;const P=this;let D=!1,B=null,W=null,C=null,H=null;this._outputColorSpace=nn;let Z=0,G=0,et=null,X=-1,Q=null;const j=new de,Mt=new de;let Nt=null;const Y=new Gt(0);let pt=0,xt=e.width,Rt=e.height,gt=1,Ft=null,pe=null;const Lt=new de(0,0,xt,Rt),te=new de(0,0,xt,Rt);let ie=!1;const Ht=new Ea,Ce=new Dc;let we=!1,Ge=!1;const he=new Qt,wn=new F,Ee=new de,Ze={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Je=!1;function Qe(){return et===null?gt:1}let I=n;function je(w,L){return e.getContext(w,L)}let le,ce,ut,Se,Ct,It,b,_,O,tt,J,st,ct,q,$,at,R,K,V,ot,it,rt,Et;try{const w={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${Mc}`),e.addEventListener("webglcontextlost",Tt,!1),e.addEventListener("webglcontextrestored",Ot,!1),e.addEventListener("webglcontextcreationerror",dt,!1),I===null){const L="webgl2";if(I=je(L,w),I===null)throw je(L)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Bt()}catch(w){throw e.removeEventListener("webglcontextlost",Tt,!1),e.removeEventListener("webglcontextrestored",Ot,!1),e.removeEventListener("webglcontextcreationerror",dt,!1),Jt("WebGLRenderer: "+w.message),w}function Bt(){le=new S_(I),le.init(),it=new lw(I,le),ce=new h_(I,le,t,it),ut=new aw(I,le),ce.reversedDepthBuffer&&d&&ut.buffers.depth.setReversed(!0),W=I.createFramebuffer(),C=I.createFramebuffer(),H=I.createFramebuffer(),Se=new E_(I),Ct=new qx,It=new ow(I,le,ut,Ct,ce,it,Se),b=new w_(P),_=new T0(I),rt=new l_(I,_),O=new M_(I,_,Se,rt),tt=new T_(I,O,_,rt,Se),K=new b_(I,ce,It),$=new u_(Ct),J=new Xx(P,b,le,ce,rt,$),st=new pw(P,Ct),ct=new Yx,q=new tw(le),R=new o_(P,b,ut,tt,m,l),at=new rw(P,tt,ce),Et=new mw(I,Se,ce,ut),V=new c_(I,le,Se),ot=new y_(I,le,Se),Se.programs=J.programs,P.capabilities=ce,P.extensions=le,P.properties=Ct,P.renderLists=ct,P.shadowMap=at,P.state=ut,P.info=Se}x!==sn&&(N=new R_(x,e.width,e.height,o,s,r));const nt=new dw(P,I);this.xr=nt,this.getContext=function(){return I},this.getContextAttributes=function(){return I.getContextAttributes()},this.forceContextLoss=function(){const w=le.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){const w=le.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return gt},this.setPixelRatio=function(w){w!==void 0&&(gt=w,this.setSize(xt,Rt,!1))},this.getSize=function(w){return w.set(xt,Rt)},this.setSize=function(w,L,z=!0){if(nt.isPresenting){Pt("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=w,Rt=L,e.width=Math.floor(w*gt),e.height=Math.floor(L*gt),z===!0&&(e.style.width=w+"px",e.style.height=L+"px"),N!==null&&N.setSize(e.width,e.height),this.setViewport(0,0,w,L)},this.getDrawingBufferSize=function(w){return w.set(xt*gt,Rt*gt).floor()},this.setDrawingBufferSize=function(w,L,z){xt=w,Rt=L,gt=z,e.width=Math.floor(w*z),e.height=Math.floor(L*z),this.setViewport(0,0,w,L)},this.setEffects=function(w){if(x===sn){Jt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let L=0;L<w.length;L++)if(w[L].isOutputPass===!0){Pt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(j)},this.getViewport=function(w){return w.copy(Lt)},this.setViewport=function(w,L,z,U){w.isVector4?Lt.set(w.x,w.y,w.z,w.w):Lt.set(w,L,z,U),ut.viewport(j.copy(Lt).multiplyScalar(Qe()).round())},this.getScissor=function(w){return w.copy(te)},this.setScissor=function(w,L,z,U){w.isVector4?te.set(w.x,w.y,w.z,w.w):te.set(w,L,z,U),ut.scissor(Mt.copy(te).multiplyScalar(Qe()).round())},this.getScissorTest=function(){return ie},this.setScissorTest=function(w){ut.setScissorTest(ie=w)},this.setOpaqueSort=function(w){Ft=w},this.setTransparentSort=function(w){pe=w},this.getClearColor=function(w){return w.copy(R.getClearColor())},this.setClearColor=function(){R.setClearColor(...arguments)},this.getClearAlpha=function(){return R.getClearAlpha()},this.setClearAlpha=function(){R.setClearAlpha(...arguments)},this.clear=function(w=!0,L=!0,z=!0){let U=0;if(w){let k=!1;if(et!==null){const ht=et.texture.format;k=g.has(ht)}if(k){const ht=et.texture.type,_t=p.has(ht),lt=R.getClearColor(),vt=R.getClearAlpha(),yt=lt.r,Ut=lt.g,Vt=lt.b;_t?(S[0]=yt,S[1]=Ut,S[2]=Vt,S[3]=vt,I.clearBufferuiv(I.COLOR,0,S)):(T[0]=yt,T[1]=Ut,T[2]=Vt,T[3]=vt,I.clearBufferiv(I.COLOR,0,T))}else U|=I.COLOR_BUFFER_BIT}L&&(U|=I.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),z&&(U|=I.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),U!==0&&I.clear(U)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),B=w},this.dispose=function(){e.removeEventListener("webglcontextlost",Tt,!1),e.removeEventListener("webglcontextrestored",Ot,!1),e.removeEventListener("webglcontextcreationerror",dt,!1),R.dispose(),ct.dispose(),q.dispose(),It.dispose(),Ct.dispose(),b.dispose(),tt.dispose(),O.dispose(),rt.dispose(),Et.dispose(),J.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",lh),nt.removeEventListener("sessionend",ch),wi.stop()};function Tt(w){w.preventDefault(),Rh("WebGLRenderer: Context Lost."),D=!0}function Ot(){Rh("WebGLRenderer: Context Restored."),D=!1;const w=Se.autoReset,L=at.enabled,z=at.autoUpdate,U=at.needsUpdate,k=at.type;Bt(),Se.autoReset=w,at.enabled=L,at.autoUpdate=z,at.needsUpdate=U,at.type=k}function dt(w){Jt("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function ee(w){const L=w.target;L.removeEventListener("dispose",ee),be(L)}function be(w){ei(w),Ct.remove(w)}function ei(w){const L=Ct.get(w).programs;L!==void 0&&(L.forEach(function(z){J.releaseProgram(z)}),w.isShaderMaterial&&J.releaseShaderCache(w))}this.renderBufferDirect=function(w,L,z,U,k,ht){L===null&&(L=Ze);const _t=k.isMesh&&k.matrixWorld.determinantAffine()<0,lt=Hp(w,L,z,U,k);ut.setMaterial(U,_t);let vt=z.index,yt=1;if(U.wireframe===!0){if(vt=O.getWireframeAttribute(z),vt===void 0)return;yt=2}const Ut=z.drawRange,Vt=z.attributes.position;let wt=Ut.start*yt,Wt=(Ut.start+Ut.count)*yt;ht!==null&&(wt=Math.max(wt,ht.start*yt),Wt=Math.min(Wt,(ht.start+ht.count)*yt)),vt!==null?(wt=Math.max(wt,0),Wt=Math.min(Wt,vt.count)):Vt!=null&&(wt=Math.max(wt,0),Wt=Math.min(Wt,Vt.count));const me=Wt-wt;if(me<0||me===1/0)return;rt.setup(k,U,lt,z,vt);let ae,se=V;if(vt!==null&&(ae=_.get(vt),se=ot,se.setIndex(ae)),k.isMesh)U.wireframe===!0?(ut.setLineWidth(U.wireframeLinewidth*Qe()),se.setMode(I.LINES)):se.setMode(I.TRIANGLES);else if(k.isLine){let Ie=U.linewidth;Ie===void 0&&(Ie=1),ut.setLineWidth(Ie*Qe()),k.isLineSegments?se.setMode(I.LINES):k.isLineLoop?se.setMode(I.LINE_LOOP):se.setMode(I.LINE_STRIP)}else k.isPoints?se.setMode(I.POINTS):k.isSprite&&se.setMode(I.TRIANGLES);if(k.isBatchedMesh)if(le.get("WEBGL_multi_draw"))se.renderMultiDraw(k._multiDrawStarts,k._multiDrawCounts,k._multiDrawCount);else{const Ie=k._multiDrawStarts,St=k._multiDrawCounts,Oe=k._multiDrawCount,Zt=vt?_.get(vt).bytesPerElement:1,Si=Ct.get(U).currentProgram.getUniforms();for(let De=0;De<Oe;De++)Si.setValue(I,"_gl_DrawID",De),se.render(Ie[De]/Zt,St[De])}else if(k.isInstancedMesh)se.renderInstances(wt,me,k.count);else if(z.isInstancedBufferGeometry){const Ie=z._maxInstanceCount!==void 0?z._maxInstanceCount:1/0,St=Math.min(z.instanceCount,Ie);se.renderInstances(wt,me,St)}else se.render(wt,me)};function oh(w,L,z,U){B!==null&&w.isNodeMaterial&&B.setObject(U,w),we===!0&&$.setState(w,z,!1),w.transparent===!0&&w.side===Ln&&w.forceSinglePass===!1?(w.side=Ve,w.needsUpdate=!0,xs(w,L,U),w.side=mi,w.needsUpdate=!0,xs(w,L,U),w.side=Ln):xs(w,L,U)}this.compile=function(w,L,z=null){z===null&&(z=w),B!==null&&B.renderStart(w,L,z),E=q.get(z),E.init(L),y.push(E),z.traverseVisible(function(k){k.isLight&&k.layers.test(L.layers)&&(E.pushLight(k),k.castShadow&&E.pushShadow(k))}),w!==z&&w.traverseVisible(function(k){k.isLight&&k.layers.test(L.layers)&&(E.pushLight(k),k.castShadow&&E.pushShadow(k))}),E.setupLights(),B!==null&&B.updateLights(E.state.lightsArray),Ge=this.localClippingEnabled,we=$.init(this.clippingPlanes,Ge),we===!0&&$.setGlobalState(this.clippingPlanes,L),B!==null&&at.render(E.state.shadowsArray,z,L);const U=new Set;return w.traverse(function(k){if(!(k.isMesh||k.isPoints||k.isLine||k.isSprite))return;const ht=k.material;if(ht)if(Array.isArray(ht))for(let _t=0;_t<ht.length;_t++){const lt=ht[_t];oh(lt,z,L,k),U.add(lt)}else oh(ht,z,L,k),U.add(ht)}),E=y.pop(),B!==null&&B.renderEnd(),U},this.compileAsync=function(w,L,z=null){const U=this.compile(w,L,z);return new Promise(k=>{function ht(){if(U.forEach(function(_t){const vt=Ct.get(_t).currentProgram;(vt===void 0||vt.isReady())&&U.delete(_t)}),U.size===0){k(w);return}setTimeout(ht,10)}le.get("KHR_parallel_shader_compile")!==null?ht():setTimeout(ht,10)})};let Za=null;function zp(w){Za&&Za(w)}function lh(){wi.stop()}function ch(){wi.start()}const wi=new xf;wi.setAnimationLoop(zp),typeof self<"u"&&wi.setContext(self),this.setAnimationLoop=function(w){Za=w,nt.setAnimationLoop(w),w===null?wi.stop():wi.start()},nt.addEventListener("sessionstart",lh),nt.addEventListener("sessionend",ch),this.render=function(w,L){if(L!==void 0&&L.isCamera!==!0){Jt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;B!==null&&B.renderStart(w,L);const z=nt.enabled===!0&&nt.isPresenting===!0,U=N!==null&&(et===null||z)&&N.begin(P,et);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),L.parent===null&&L.matrixWorldAutoUpdate===!0&&L.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(L),L=nt.getCamera()),w.isScene===!0&&w.onBeforeRender(P,w,L,et),E=q.get(w,y.length),E.init(L),E.state.textureUnits=It.getTextureUnits(),y.push(E),he.multiplyMatrices(L.projectionMatrix,L.matrixWorldInverse),L.isArrayCamera?Ce.setFromArrayCamera(L):Ht.setFromProjectionMatrix(he,gn,L.reversedDepth),Ge=this.localClippingEnabled,we=$.init(this.clippingPlanes,Ge),A=ct.get(w,v.length),A.init(),v.push(A),this.info.render.frame++,nt.enabled===!0&&nt.isPresenting===!0){const _t=P.xr.getDepthSensingMesh();_t!==null&&Ja(_t,L,-1/0,P.sortObjects)}Ja(w,L,0,P.sortObjects),A.finish(),B!==null&&B.updateLights(E.state.lightsArray),P.sortObjects===!0&&A.sort(Ft,pe),Je=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,Je&&R.addToRenderList(A,w),this.info.autoReset===!0&&this.info.reset(),we===!0&&$.beginShadows();const k=E.state.shadowsArray;if(at.render(k,w,L),we===!0&&$.endShadows(),(U&&N.hasRenderPass())===!1){const _t=A.opaque,lt=A.transmissive;if(E.setupLights(),L.isArrayCamera){const vt=L.cameras;if(lt.length>0)for(let yt=0,Ut=vt.length;yt<Ut;yt++){const Vt=vt[yt];uh(_t,lt,w,Vt)}Je&&R.render(w);for(let yt=0,Ut=vt.length;yt<Ut;yt++){const Vt=vt[yt];hh(A,w,Vt,Vt.viewport)}}else lt.length>0&&uh(_t,lt,w,L),Je&&R.render(w),hh(A,w,L)}et!==null&&G===0&&(It.updateMultisampleRenderTarget(et),It.updateRenderTargetMipmap(et)),U&&N.end(P),w.isScene===!0&&w.onAfterRender(P,w,L),rt.resetDefaultState(),X=-1,Q=null,y.pop(),y.length>0?(E=y[y.length-1],It.setTextureUnits(E.state.textureUnits),we===!0&&$.setGlobalState(P.clippingPlanes,E.state.camera)):E=null,v.pop(),v.length>0?A=v[v.length-1]:A=null,B!==null&&B.renderEnd()};function Ja(w,L,z,U){if(w.visible===!1)return;if(w.layers.test(L.layers)){if(w.isGroup)z=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(L);else if(w.isLight)E.pushLight(w),w.castShadow&&E.pushShadow(w);else if(w.isSprite){const _t=L.isArrayCamera?Ce:Ht;if(!w.frustumCulled||w.intersectsFrustum(_t)){U&&Ee.setFromMatrixPosition(w.matrixWorld).applyMatrix4(he);const lt=tt.update(w),vt=w.material;vt.visible&&A.push(w,lt,vt,z,Ee.z,null,L)}}else if(w.isMesh||w.isLine||w.isPoints){const _t=L.isArrayCamera?Ce:Ht;if(!w.frustumCulled||w.intersectsFrustum(_t)){const lt=tt.update(w),vt=w.material;if(U&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),Ee.copy(w.boundingSphere.center)):(lt.boundingSphere===null&&lt.computeBoundingSphere(),Ee.copy(lt.boundingSphere.center)),Ee.applyMatrix4(w.matrixWorld).applyMatrix4(he)),Array.isArray(vt)){const yt=lt.groups;for(let Ut=0,Vt=yt.length;Ut<Vt;Ut++){const wt=yt[Ut],Wt=vt[wt.materialIndex];Wt&&Wt.visible&&A.push(w,lt,Wt,z,Ee.z,wt,L)}}else vt.visible&&A.push(w,lt,vt,z,Ee.z,null,L)}}}const ht=w.children;for(let _t=0,lt=ht.length;_t<lt;_t++)Ja(ht[_t],L,z,U)}function hh(w,L,z,U){const{opaque:k,transmissive:ht,transparent:_t}=w;E.setupLightsView(z),we===!0&&$.setGlobalState(P.clippingPlanes,z),U&&ut.viewport(j.copy(U)),k.length>0&&lr(k,L,z),ht.length>0&&lr(ht,L,z),_t.length>0&&lr(_t,L,z),ut.buffers.depth.setTest(!0),ut.buffers.depth.setMask(!0),ut.buffers.color.setMask(!0),ut.setPolygonOffset(!1)}function uh(w,L,z,U){if((z.isScene===!0?z.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[U.id]===void 0){const wt=le.has("EXT_color_buffer_half_float")||le.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[U.id]=new _n(1,1,{generateMipmaps:!0,type:wt?xn:sn,minFilter:ui,samples:Math.max(4,ce.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:qt.workingColorSpace})}const ht=E.state.transmissionRenderTarget[U.id],_t=U.viewport||j;ht.setSize(_t.z*P.transmissionResolutionScale,_t.w*P.transmissionResolutionScale);const lt=P.getRenderTarget(),vt=P.getActiveCubeFace(),yt=P.getActiveMipmapLevel();P.setRenderTarget(ht),P.getClearColor(Y),pt=P.getClearAlpha(),pt<1&&P.setClearColor(16777215,.5),P.clear(),Je&&R.render(z);const Ut=P.toneMapping;P.toneMapping=Qn;const Vt=U.viewport;if(U.viewport!==void 0&&(U.viewport=void 0),E.setupLightsView(U),we===!0&&$.setGlobalState(P.clippingPlanes,U),lr(w,z,U),It.updateMultisampleRenderTarget(ht),It.updateRenderTargetMipmap(ht),le.has("WEBGL_multisampled_render_to_texture")===!1){let wt=!1;for(let Wt=0,me=L.length;Wt<me;Wt++){const ae=L[Wt],{object:se,geometry:Ie,material:St,group:Oe}=ae;if(St.side===Ln&&se.layers.test(U.layers)){const Zt=St.side;St.side=Ve,St.needsUpdate=!0,dh(se,z,U,Ie,St,Oe),St.side=Zt,St.needsUpdate=!0,wt=!0}}wt===!0&&(It.updateMultisampleRenderTarget(ht),It.updateRenderTargetMipmap(ht))}P.setRenderTarget(lt,vt,yt),P.setClearColor(Y,pt),Vt!==void 0&&(U.viewport=Vt),P.toneMapping=Ut}function lr(w,L,z){const U=L.isScene===!0?L.overrideMaterial:null;for(let k=0,ht=w.length;k<ht;k++){const _t=w[k],{object:lt,geometry:vt,group:yt}=_t;let Ut=_t.material;Ut.allowOverride===!0&&U!==null&&(Ut=U),lt.layers.test(z.layers)&&dh(lt,L,z,vt,Ut,yt)}}function dh(w,L,z,U,k,ht){B!==null&&k.isNodeMaterial&&B.setObject(w,k),w.onBeforeRender(P,L,z,U,k,ht),w.modelViewMatrix.multiplyMatrices(z.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),k.onBeforeRender(P,L,z,U,w,ht),k.transparent===!0&&k.side===Ln&&k.forceSinglePass===!1?(k.side=Ve,k.needsUpdate=!0,P.renderBufferDirect(z,L,U,k,w,ht),k.side=mi,k.needsUpdate=!0,P.renderBufferDirect(z,L,U,k,w,ht),k.side=Ln):P.renderBufferDirect(z,L,U,k,w,ht),w.onAfterRender(P,L,z,U,k,ht)}function fh(w){let L=0;for(const z of w)z.texture!==null&&L++;return L}function xs(w,L,z){L.isScene!==!0&&(L=Ze);const U=Ct.get(w),k=E.state.lights,ht=E.state.shadowsArray,_t=k.state.version,lt=J.getParameters(w,k.state,ht,L,z,E.state.lightProbeGridArray),vt=J.getProgramCacheKey(lt);let yt=U.programs;U.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?L.environment:null,U.fog=L.fog;const Ut=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;U.envMap=b.get(w.envMap||U.environment,Ut),U.envMapRotation=U.environment!==null&&w.envMap===null?L.environmentRotation:w.envMapRotation,yt===void 0&&(w.addEventListener("dispose",ee),yt=new Map,U.programs=yt,U.programVariants=new Map);let Vt=yt.get(vt);if(Vt!==void 0){if(U.currentProgram===Vt&&U.lightsStateVersion===_t)return mh(w,lt),Vt}else lt.uniforms=J.getUniforms(w),B!==null&&w.isNodeMaterial&&B.build(w,z,lt),w.onBeforeCompile(lt,P),Vt=J.acquireProgram(lt,vt),yt.set(vt,Vt),U.uniforms=lt.uniforms;const wt=U.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(wt.clippingPlanes=$.uniform),mh(w,lt),U.needsLights=Wp(w),U.lightsStateVersion=_t,U.needsLights&&(wt.ambientLightColor.value=k.state.ambient,wt.lightProbe.value=k.state.probe,wt.sunLights.value=k.state.sun,wt.sunLightShadows.value=k.state.sunShadow,wt.directionalLights.value=k.state.directional,wt.directionalLightShadows.value=k.state.directionalShadow,wt.spotLights.value=k.state.spot,wt.spotLightShadows.value=k.state.spotShadow,wt.rectAreaLights.value=k.state.rectArea,wt.ltc_1.value=k.state.rectAreaLTC1,wt.ltc_2.value=k.state.rectAreaLTC2,wt.pointLights.value=k.state.point,wt.pointLightShadows.value=k.state.pointShadow,wt.hemisphereLights.value=k.state.hemi,wt.sunShadowMatrix.value=k.state.sunShadowMatrix,wt.sunShadowCascade.value=k.state.sunShadowCascade,wt.directionalShadowMatrix.value=k.state.directionalShadowMatrix,wt.spotLightMatrix.value=k.state.spotLightMatrix,wt.spotLightMap.value=k.state.spotLightMap,wt.pointShadowMatrix.value=k.state.pointShadowMatrix),U.numLightProbeGrids=fh(E.state.lightProbeGridArray),U.currentProgram=Vt,U.uniformsList=null,Vt}function Gp(w,L,z,U,k){const ht=Ct.get(w),_t=ht.currentProgram.id+","+U+","+k;let lt=ht.programVariants.get(_t);return lt===void 0?(lt=xs(w,L,z),ht.programVariants.set(_t,lt)):(ht.currentProgram=lt,ht.uniformsList=null,ht.outputColorSpace=U,ht.toneMapping=k),lt}function ph(w){if(w.uniformsList===null){const L=w.currentProgram.getUniforms();w.uniformsList=oa.seqWithValue(L.seq,w.uniforms)}return w.uniformsList}function mh(w,L){const z=Ct.get(w);z.outputColorSpace=L.outputColorSpace,z.batching=L.batching,z.batchingColor=L.batchingColor,z.instancing=L.instancing,z.instancingColor=L.instancingColor,z.instancingMorph=L.instancingMorph,z.skinning=L.skinning,z.morphTargets=L.morphTargets,z.morphNormals=L.morphNormals,z.morphColors=L.morphColors,z.morphTargetsCount=L.morphTargetsCount,z.numClippingPlanes=L.numClippingPlanes,z.numIntersection=L.numClipIntersection,z.vertexAlphas=L.vertexAlphas,z.vertexTangents=L.vertexTangents,z.toneMapping=L.toneMapping}function Hp(w,L,z,U,k){L.isScene!==!0&&(L=Ze),It.resetTextureUnits();const ht=L.fog,_t=U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial?L.environment:null,lt=et===null?P.outputColorSpace:et.isXRRenderTarget===!0?et.texture.colorSpace:qt.workingColorSpace,vt=U.isMeshStandardMaterial||U.isMeshLambertMaterial&&!U.envMap||U.isMeshPhongMaterial&&!U.envMap,yt=b.get(U.envMap||_t,vt),Ut=U.vertexColors===!0&&!!z.attributes.color&&z.attributes.color.itemSize===4,Vt=!!z.attributes.tangent&&(!!U.normalMap||U.anisotropy>0),wt=!!z.morphAttributes.position,Wt=!!z.morphAttributes.normal,me=!!z.morphAttributes.color;let ae=Qn;U.toneMapped&&(et===null||et.isXRRenderTarget===!0)&&(ae=P.toneMapping);const se=z.morphAttributes.position||z.morphAttributes.normal||z.morphAttributes.color,Ie=se!==void 0?se.length:0,St=Ct.get(U),Oe=E.state.lights;if(we===!0&&(Ge===!0||w!==Q)){const ue=w===Q&&U.id===X;$.setState(U,w,ue)}let Zt=!1,Si=!1;U.version===St.__version?St.needsLights&&St.lightsStateVersion!==Oe.state.version||k.isBatchedMesh&&St.batching===!1||!k.isBatchedMesh&&St.batching===!0||k.isBatchedMesh&&St.batchingColor===!0&&k._colorsTexture===null||k.isBatchedMesh&&St.batchingColor===!1&&k._colorsTexture!==null||k.isInstancedMesh&&St.instancing===!1||!k.isInstancedMesh&&St.instancing===!0||k.isSkinnedMesh&&St.skinning===!1||!k.isSkinnedMesh&&St.skinning===!0||k.isInstancedMesh&&St.instancingColor===!0&&k.instanceColor===null||k.isInstancedMesh&&St.instancingColor===!1&&k.instanceColor!==null||k.isInstancedMesh&&St.instancingMorph===!0&&k.morphTexture===null||k.isInstancedMesh&&St.instancingMorph===!1&&k.morphTexture!==null||St.envMap!==yt||U.fog===!0&&St.fog!==ht||St.numClippingPlanes!==void 0&&(St.numClippingPlanes!==$.numPlanes||St.numIntersection!==$.numIntersection)||St.vertexAlphas!==Ut||St.vertexTangents!==Vt||St.morphTargets!==wt||St.morphNormals!==Wt||St.morphColors!==me||St.morphTargetsCount!==Ie||St.numLightProbeGrids!==fh(E.state.lightProbeGridArray)?Zt=!0:(St.outputColorSpace!==lt||St.toneMapping!==ae)&&(Si=!0):(Zt=!0,St.__version=U.version);let De=St.currentProgram;(Zt===!0||Si===!0)&&(De=Si===!0?Gp(U,L,k,lt,ae):xs(U,L,k),B&&U.isNodeMaterial&&B.onUpdateProgram(U,De,St));let cr=!1,ni=!1,Mi=!1;const $t=De.getUniforms(),Le=St.uniforms;if(ut.useProgram(De.program)&&(cr=!0,ni=!0,Mi=!0),U.id!==X&&(X=U.id,ni=!0),cr||Q!==w){ut.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),$t.setValue(I,"projectionMatrix",w.projectionMatrix),$t.setValue(I,"viewMatrix",w.matrixWorldInverse);const Te=$t.map.cameraPosition;Te!==void 0&&Te.setValue(I,wn.setFromMatrixPosition(w.matrixWorld)),ce.logarithmicDepthBuffer&&$t.setValue(I,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(U.isMeshPhongMaterial||U.isMeshToonMaterial||U.isMeshLambertMaterial||U.isMeshBasicMaterial||U.isMeshStandardMaterial||U.isShaderMaterial)&&$t.setValue(I,"isOrthographic",w.isOrthographicCamera===!0),Q!==w&&(Q=w,ni=!0,Mi=!0)}if(St.needsLights&&(Oe.state.sunShadowMap.length>0&&$t.setValue(I,"sunShadowMap",Oe.state.sunShadowMap,It),Oe.state.directionalShadowMap.length>0&&$t.setValue(I,"directionalShadowMap",Oe.state.directionalShadowMap,It),Oe.state.spotShadowMap.length>0&&$t.setValue(I,"spotShadowMap",Oe.state.spotShadowMap,It),Oe.state.pointShadowMap.length>0&&$t.setValue(I,"pointShadowMap",Oe.state.pointShadowMap,It)),k.isSkinnedMesh){$t.setOptional(I,k,"bindMatrix"),$t.setOptional(I,k,"bindMatrixInverse");const ue=k.skeleton;ue&&(ue.boneTexture===null&&ue.computeBoneTexture(),$t.setValue(I,"boneTexture",ue.boneTexture,It))}k.isBatchedMesh&&($t.setOptional(I,k,"batchingTexture"),$t.setValue(I,"batchingTexture",k._matricesTexture,It),$t.setOptional(I,k,"batchingIdTexture"),$t.setValue(I,"batchingIdTexture",k._indirectTexture,It),$t.setOptional(I,k,"batchingColorTexture"),k._colorsTexture!==null&&$t.setValue(I,"batchingColorTexture",k._colorsTexture,It));const cn=z.morphAttributes;if((cn.position!==void 0||cn.normal!==void 0||cn.color!==void 0)&&K.update(k,z,De),(ni||St.receiveShadow!==k.receiveShadow)&&(St.receiveShadow=k.receiveShadow,$t.setValue(I,"receiveShadow",k.receiveShadow)),(U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial)&&U.envMap===null&&L.environment!==null&&(Le.envMapIntensity.value=L.environmentIntensity),Le.dfgLUT!==void 0&&(Le.dfgLUT.value=vw()),ni){if($t.setValue(I,"toneMappingExposure",P.toneMappingExposure),St.needsLights&&Vp(Le,Mi),ht&&U.fog===!0&&st.refreshFogUniforms(Le,ht),st.refreshMaterialUniforms(Le,U,gt,Rt,E.state.transmissionRenderTarget[w.id]),St.needsLights&&St.numLightProbeGrids>0){const ue=M;let Te=0;for(const On of E.state.lightProbeGridArray)On.texture!==null&&(ue.textures[Te]=On.texture,ue.min[Te]=On.boundingBox.min,ue.max[Te]=On.boundingBox.max,ue.resolution[Te]=On.resolution,Te++);for(const On in ue)ue[On].length=Te;Le.probesSH.value=ue.textures,Le.probesMin.value=ue.min,Le.probesMax.value=ue.max,Le.probesResolution.value=ue.resolution}oa.upload(I,ph(St),Le,It)}if(U.isShaderMaterial&&U.uniformsNeedUpdate===!0&&(oa.upload(I,ph(St),Le,It),U.uniformsNeedUpdate=!1),U.isSpriteMaterial&&$t.setValue(I,"center",k.center),$t.setValue(I,"modelViewMatrix",k.modelViewMatrix),$t.setValue(I,"normalMatrix",k.normalMatrix),$t.setValue(I,"modelMatrix",k.matrixWorld),U.uniformsGroups!==void 0){const ue=U.uniformsGroups;for(let Te=0,On=ue.length;Te<On;Te++){const vh=ue[Te];Et.update(vh,De),Et.bind(vh,De)}}return De}function Vp(w,L){w.ambientLightColor.needsUpdate=L,w.lightProbe.needsUpdate=L,w.sunLights.needsUpdate=L,w.sunLightShadows.needsUpdate=L,w.directionalLights.needsUpdate=L,w.directionalLightShadows.needsUpdate=L,w.pointLights.needsUpdate=L,w.pointLightShadows.needsUpdate=L,w.spotLights.needsUpdate=L,w.spotLightShadows.needsUpdate=L,w.rectAreaLights.needsUpdate=L,w.hemisphereLights.needsUpdate=L}function Wp(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return et},this.setRenderTargetTextures=function(w,L,z){const U=Ct.get(w);U.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,U.__autoAllocateDepthBuffer===!1&&(U.__useRenderToTexture=!1),Ct.get(w.texture).__webglTexture=L,Ct.get(w.depthTexture).__webglTexture=U.__autoAllocateDepthBuffer?void 0:z,U.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,L){const z=Ct.get(w);z.__webglFramebuffer=L,z.__useDefaultFramebuffer=L===void 0},this.setRenderTarget=function(w,L=0,z=0){et=w,Z=L,G=z;let U=null,k=!1,ht=!1;if(w){const lt=Ct.get(w);if(lt.__useDefaultFramebuffer!==void 0){ut.bindFramebuffer(I.FRAMEBUFFER,lt.__webglFramebuffer),j.copy(w.viewport),Mt.copy(w.scissor),Nt=w.scissorTest,ut.viewport(j),ut.scissor(Mt),ut.setScissorTest(Nt),X=-1;return}else if(lt.__webglFramebuffer===void 0)It.setupRenderTarget(w);else if(lt.__hasExternalTextures)It.rebindTextures(w,Ct.get(w.texture).__webglTexture,Ct.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){const Ut=w.depthTexture;if(lt.__boundDepthTexture!==Ut){if(Ut!==null&&Ct.has(Ut)&&(w.width!==Ut.image.width||w.height!==Ut.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");It.setupDepthRenderbuffer(w)}}const vt=w.texture;(vt.isData3DTexture||vt.isDataArrayTexture||vt.isCompressedArrayTexture)&&(ht=!0);const yt=Ct.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(yt[L])?U=yt[L][z]:U=yt[L],k=!0):w.samples>0&&It.useMultisampledRTT(w)===!1?U=Ct.get(w).__webglMultisampledFramebuffer:Array.isArray(yt)?U=yt[z]:U=yt,j.copy(w.viewport),Mt.copy(w.scissor),Nt=w.scissorTest}else j.copy(Lt).multiplyScalar(gt).floor(),Mt.copy(te).multiplyScalar(gt).floor(),Nt=ie;if(z!==0&&(U=W),ut.bindFramebuffer(I.FRAMEBUFFER,U)&&ut.drawBuffers(w,U),ut.viewport(j),ut.scissor(Mt),ut.setScissorTest(Nt),k){const lt=Ct.get(w.texture);I.framebufferTexture2D(I.FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_CUBE_MAP_POSITIVE_X+L,lt.__webglTexture,z)}else if(ht){const lt=L;for(let vt=0;vt<w.textures.length;vt++){const yt=Ct.get(w.textures[vt]);I.framebufferTextureLayer(I.FRAMEBUFFER,I.COLOR_ATTACHMENT0+vt,yt.__webglTexture,z,lt)}}else if(w!==null&&z!==0){const lt=Ct.get(w.texture);I.framebufferTexture2D(I.FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_2D,lt.__webglTexture,z)}X=-1};function gh(w){const L=Ct.get(w);return(L.__readFormat!==w.format||L.__readType!==w.type)&&(L.__readFormat=w.format,L.__readType=w.type,L.__formatReadable=ce.textureFormatReadable(w.format),L.__typeReadable=ce.textureTypeReadable(w.type)),L}this.readRenderTargetPixels=function(w,L,z,U,k,ht,_t,lt=0){if(!(w&&w.isWebGLRenderTarget)){Jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let vt=Ct.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&_t!==void 0&&(vt=vt[_t],Array.isArray(vt)&&(vt=vt[0])),vt){ut.bindFramebuffer(I.FRAMEBUFFER,vt);try{const yt=w.textures[lt],Ut=yt.format,Vt=yt.type;w.textures.length>1&&I.readBuffer(I.COLOR_ATTACHMENT0+lt);const wt=gh(yt);if(wt.__formatReadable===!1){Jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(wt.__typeReadable===!1){Jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}L>=0&&L<=w.width-U&&z>=0&&z<=w.height-k&&I.readPixels(L,z,U,k,it.convert(Ut),it.convert(Vt),ht)}finally{const yt=et!==null?Ct.get(et).__webglFramebuffer:null;ut.bindFramebuffer(I.FRAMEBUFFER,yt)}}},this.readRenderTargetPixelsAsync=async function(w,L,z,U,k,ht,_t,lt=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let vt=Ct.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&_t!==void 0&&(vt=vt[_t],Array.isArray(vt)&&(vt=vt[0])),vt)if(L>=0&&L<=w.width-U&&z>=0&&z<=w.height-k){ut.bindFramebuffer(I.FRAMEBUFFER,vt);const yt=w.textures[lt],Ut=yt.format,Vt=yt.type;w.textures.length>1&&I.readBuffer(I.COLOR_ATTACHMENT0+lt);const wt=gh(yt);if(wt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(wt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");const Wt=I.createBuffer();I.bindBuffer(I.PIXEL_PACK_BUFFER,Wt),I.bufferData(I.PIXEL_PACK_BUFFER,ht.byteLength,I.STREAM_READ),I.readPixels(L,z,U,k,it.convert(Ut),it.convert(Vt),0),I.bindBuffer(I.PIXEL_PACK_BUFFER,null);const me=et!==null?Ct.get(et).__webglFramebuffer:null;ut.bindFramebuffer(I.FRAMEBUFFER,me);const ae=I.fenceSync(I.SYNC_GPU_COMMANDS_COMPLETE,0);return I.flush(),await Bm(I,ae,4),I.bindBuffer(I.PIXEL_PACK_BUFFER,Wt),I.getBufferSubData(I.PIXEL_PACK_BUFFER,0,ht),I.bindBuffer(I.PIXEL_PACK_BUFFER,null),I.deleteBuffer(Wt),I.deleteSync(ae),ht}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,L=null,z=0){const U=Math.pow(2,-z),k=Math.floor(w.image.width*U),ht=Math.floor(w.image.height*U),_t=L!==null?L.x:0,lt=L!==null?L.y:0;It.setTexture2D(w,0),I.copyTexSubImage2D(I.TEXTURE_2D,z,0,0,_t,lt,k,ht),ut.unbindTexture()},this.copyTextureToTexture=function(w,L,z=null,U=null,k=0,ht=0){let _t,lt,vt,yt,Ut,Vt,wt,Wt,me;const ae=w.isCompressedTexture?w.mipmaps[ht]:w.image;if(z!==null)_t=z.max.x-z.min.x,lt=z.max.y-z.min.y,vt=z.isBox3?z.max.z-z.min.z:1,yt=z.min.x,Ut=z.min.y,Vt=z.isBox3?z.min.z:0;else{const $t=Math.pow(2,-k);_t=Math.floor(ae.width*$t),lt=Math.floor(ae.height*$t),w.isDataArrayTexture?vt=ae.depth:w.isData3DTexture?vt=Math.floor(ae.depth*$t):vt=1,yt=0,Ut=0,Vt=0}U!==null?(wt=U.x,Wt=U.y,me=U.z):(wt=0,Wt=0,me=0);const se=it.convert(L.format),Ie=it.convert(L.type);let St;L.isData3DTexture?(It.setTexture3D(L,0),St=I.TEXTURE_3D):L.isDataArrayTexture||L.isCompressedArrayTexture?(It.setTexture2DArray(L,0),St=I.TEXTURE_2D_ARRAY):(It.setTexture2D(L,0),St=I.TEXTURE_2D),ut.activeTexture(I.TEXTURE0),ut.pixelStorei(I.UNPACK_FLIP_Y_WEBGL,L.flipY),ut.pixelStorei(I.UNPACK_PREMULTIPLY_ALPHA_WEBGL,L.premultiplyAlpha),ut.pixelStorei(I.UNPACK_ALIGNMENT,L.unpackAlignment);const Oe=ut.getParameter(I.UNPACK_ROW_LENGTH),Zt=ut.getParameter(I.UNPACK_IMAGE_HEIGHT),Si=ut.getParameter(I.UNPACK_SKIP_PIXELS),De=ut.getParameter(I.UNPACK_SKIP_ROWS),cr=ut.getParameter(I.UNPACK_SKIP_IMAGES);ut.pixelStorei(I.UNPACK_ROW_LENGTH,ae.width),ut.pixelStorei(I.UNPACK_IMAGE_HEIGHT,ae.height),ut.pixelStorei(I.UNPACK_SKIP_PIXELS,yt),ut.pixelStorei(I.UNPACK_SKIP_ROWS,Ut),ut.pixelStorei(I.UNPACK_SKIP_IMAGES,Vt);const ni=w.isDataArrayTexture||w.isData3DTexture,Mi=L.isDataArrayTexture||L.isData3DTexture;if(w.isDepthTexture){const $t=Ct.get(w),Le=Ct.get(L),cn=Ct.get($t.__renderTarget),ue=Ct.get(Le.__renderTarget);ut.bindFramebuffer(I.READ_FRAMEBUFFER,cn.__webglFramebuffer),ut.bindFramebuffer(I.DRAW_FRAMEBUFFER,ue.__webglFramebuffer);for(let Te=0;Te<vt;Te++)ni&&(I.framebufferTextureLayer(I.READ_FRAMEBUFFER,I.COLOR_ATTACHMENT0,Ct.get(w).__webglTexture,k,Vt+Te),I.framebufferTextureLayer(I.DRAW_FRAMEBUFFER,I.COLOR_ATTACHMENT0,Ct.get(L).__webglTexture,ht,me+Te)),I.blitFramebuffer(yt,Ut,yt+_t,Ut+lt,wt,Wt,wt+_t,Wt+lt,I.DEPTH_BUFFER_BIT,I.NEAREST);ut.bindFramebuffer(I.READ_FRAMEBUFFER,null),ut.bindFramebuffer(I.DRAW_FRAMEBUFFER,null)}else if(k!==0||w.isRenderTargetTexture||Ct.has(w)){const $t=Ct.get(w),Le=Ct.get(L);ut.bindFramebuffer(I.READ_FRAMEBUFFER,C),ut.bindFramebuffer(I.DRAW_FRAMEBUFFER,H);for(let cn=0;cn<vt;cn++)ni?I.framebufferTextureLayer(I.READ_FRAMEBUFFER,I.COLOR_ATTACHMENT0,$t.__webglTexture,k,Vt+cn):I.framebufferTexture2D(I.READ_FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_2D,$t.__webglTexture,k),Mi?I.framebufferTextureLayer(I.DRAW_FRAMEBUFFER,I.COLOR_ATTACHMENT0,Le.__webglTexture,ht,me+cn):I.framebufferTexture2D(I.DRAW_FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_2D,Le.__webglTexture,ht),k!==0?I.blitFramebuffer(yt,Ut,yt+_t,Ut+lt,wt,Wt,wt+_t,Wt+lt,I.COLOR_BUFFER_BIT,I.NEAREST):Mi?I.copyTexSubImage3D(St,ht,wt,Wt,me+cn,yt,Ut,_t,lt):I.copyTexSubImage2D(St,ht,wt,Wt,yt,Ut,_t,lt);ut.bindFramebuffer(I.READ_FRAMEBUFFER,null),ut.bindFramebuffer(I.DRAW_FRAMEBUFFER,null)}else Mi?w.isDataTexture||w.isData3DTexture?I.texSubImage3D(St,ht,wt,Wt,me,_t,lt,vt,se,Ie,ae.data):L.isCompressedArrayTexture?I.compressedTexSubImage3D(St,ht,wt,Wt,me,_t,lt,vt,se,ae.data):I.texSubImage3D(St,ht,wt,Wt,me,_t,lt,vt,se,Ie,ae):w.isDataTexture?I.texSubImage2D(I.TEXTURE_2D,ht,wt,Wt,_t,lt,se,Ie,ae.data):w.isCompressedTexture?I.compressedTexSubImage2D(I.TEXTURE_2D,ht,wt,Wt,ae.width,ae.height,se,ae.data):I.texSubImage2D(I.TEXTURE_2D,ht,wt,Wt,_t,lt,se,Ie,ae);ut.pixelStorei(I.UNPACK_ROW_LENGTH,Oe),ut.pixelStorei(I.UNPACK_IMAGE_HEIGHT,Zt),ut.pixelStorei(I.UNPACK_SKIP_PIXELS,Si),ut.pixelStorei(I.UNPACK_SKIP_ROWS,De),ut.pixelStorei(I.UNPACK_SKIP_IMAGES,cr),ht===0&&L.generateMipmaps===!0&&L.mipmapsAutoUpdate===!0&&I.generateMipmap(St),ut.unbindTexture()},this.initRenderTarget=function(w){Ct.get(w).__webglFramebuffer===void 0&&It.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?It.setTextureCube(w,0):w.isData3DTexture?It.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?It.setTexture2DArray(w,0):It.setTexture2D(w,0),ut.unbindTexture()},this.resetState=function(){Z=0,G=0,et=null,ut.reset(),rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return gn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;const e=this.getContext();e.drawingBufferColorSpace=qt._getDrawingBufferColorSpace(t),e.unpackColorSpace=qt._getUnpackColorSpace()}}const _i=`
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;
precision highp usampler2D;
precision highp sampler2DShadow;
`,Uc=`
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
`,Fc=`
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

/** What water sends itself: bright from above and around the sun, dark from the deep. */
vec3 waterColour(vec3 direction) {
  float up = direction.y * 0.5 + 0.5;
  float toSun = max(dot(direction, sunDirection), 0.0);
  return waterFog.rgb * (mix(0.45, 1.7, up * up) + 0.5 * pow(toSun, 3.0) + 0.9 * pow(toSun, 24.0));
}

/** Chunks reach past the horizon, the coarser the farther. There all has the sky's colour, but would hide its clouds, sun and stars. */
bool isBeyondHorizon(vec3 ray) { return length(ray.xz) > horizonBlocks; }

/** What the air does to light on its way. */
vec3 throughAir(vec3 colour, vec3 ray, vec3 eye) {
  float distance = length(ray);
  vec3 direction = ray / max(distance, 0.001);
  if (waterFog.w > 0.5) return mix(waterColour(direction), colour * vec3(0.42, 0.76, 0.82), exp(-distance * vec3(0.075, 0.045, 0.04)));
  float far = distance / horizonBlocks;
  float thick = far * far * 2.8 * fogDensity;
  // Mist lies low: the integral of exp(-height / 40) along the ray.
  float from = max(eye.y - seaLevel, 0.0) / 40.0;
  float to = max(eye.y + ray.y - seaLevel, 0.0) / 40.0;
  float along = abs(to - from) < 0.01 ? exp(-from) : (exp(-from) - exp(-to)) / (to - from);
  thick += mist * distance * along;
  float edge = smoothstep(0.86, 1.0, length(ray.xz) / horizonBlocks);
  float kept = exp(-thick) * (1.0 - edge);
  return mix(skyColour(normalize(vec3(direction.x, max(direction.y, 0.0) + 0.012, direction.z))), colour, kept);
}
`,Oc=`
uniform float exposure;
uniform float nightly;                // 0 by day, 1 at night: eyes see less colour

/** Filmic tone curve (after Hill's fit of the ACES reference), then sRGB. */
vec3 display(vec3 light) {
  light *= exposure;
  float grey = dot(light, vec3(0.2126, 0.7152, 0.0722));
  light = mix(light, vec3(grey) * vec3(0.78, 0.94, 1.24), nightly * 0.5);
  const mat3 toRrt = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
  const mat3 fromOdt = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
  vec3 v = toRrt * light;
  v = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
  v = clamp(fromOdt * v, 0.0, 1.0);
  return mix(12.92 * v, 1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), v));
}
`,Lf=`
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
`,Pf=`
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
`,xw=`${_i}
uniform mat4 inverseViewProjection;
out vec3 direction;
void main() {
  // One triangle over the whole picture, at the far end.
  vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  vec4 far = inverseViewProjection * vec4(at, 1.0, 1.0);
  direction = far.xyz / far.w;
  gl_Position = vec4(at, 1.0, 1.0);
}
`,ww=`${_i}${Uc}${Fc}${Oc}
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
  float toSun = dot(d, glowDirection);
  colour += sunDisc * vec3(1.0, 0.86, 0.62) * (smoothstep(0.99955, 0.99975, toSun) * 22.0 + pow(max(toSun, 0.0), 900.0) * 2.0);
  float toMoon = dot(d, moonDirection);
  float disc = 0.0;                     // of the moon, which stars do not shine through
  if (stars > 0.0 && toMoon > 0.99) {
    vec3 right = normalize(cross(moonDirection, vec3(0.0, 0.0, 1.0)));
    vec3 upward = cross(right, moonDirection);
    vec2 m = vec2(dot(d, right), dot(d, upward)) / 0.028;
    disc = 1.0 - smoothstep(0.96, 1.02, length(m));
    float spots = noise(m * 3.0 + 40.0, 1) * 0.6 + noise(m * 7.0 + 90.0, 1) * 0.4;
    colour = mix(colour, vec3(0.95, 0.94, 0.88) * (0.55 + 0.45 * spots) * 1.3, disc * min(stars * 2.0, 1.0));
    colour += vec3(0.10, 0.12, 0.16) * stars * pow(max(toMoon, 0.0), 1200.0);
  }

  float clear = 1.0;                    // of clouds
  // Clouds on a plane high above: thick where noise is high, lit from the sun's side, lost in the distance.
  if (d.y > 0.015 && eye.y < CLOUD_HEIGHT) {
    // As of a dome, not a plane: or clouds far off would be drawn out to streaks.
    float reach = (CLOUD_HEIGHT - eye.y) / (d.y + 0.09);
    vec2 at = eye.xz + d.xz * reach;
    float fine = noise(at * 4.0 + cloudShift * 4.0, 8) * 0.09 + noise(at * 10.0 + cloudShift * 9.0, 8) * 0.06;
    float base = cloudNoise(at) + fine;
    float threshold = 0.58 - cloudCover * 0.25;
    float density = smoothstep(threshold, threshold + 0.16, base);
    float toward = cloudNoise(at + glowDirection.xz * 90.0 * sign(sunDirection.y)) + fine;
    float lit = clamp(0.75 + (base - toward) * 3.2 - (base - threshold) * 0.9, 0.0, 1.3);
    vec3 shade = horizon * 0.32 + zenith * 0.3 + skyLight * 0.18;
    float silver = pow(max(toSun, 0.0), 12.0) * (1.0 - density) * 1.6;
    vec3 cloud = mix(shade, sunLight * 0.42 + skyLight * 0.36, lit * 0.85) + glow * (0.22 * lit + silver);
    float thick = density * smoothstep(0.02, 0.16, d.y);
    colour = mix(colour, cloud, thick * 0.92);
    // A star is a point: what dims a bright sky little puts it out.
    clear = pow(1.0 - thick, 4.0);
  }
  if (stars > 0.0 && d.y > -0.02) colour += starLight(d) * stars * clear * (1.0 - disc) * smoothstep(-0.02, 0.25, d.y);
  if (waterFog.w > 0.5) colour = waterColour(d);
  // Less than a step of colour, so that gradients show no bands.
  float noisy = hash2(ivec2(gl_FragCoord.xy)) - 0.5;
  result = vec4(display(colour) + noisy / 255.0, 1.0);
}
`,kc=`
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
`,Sw=`${_i}${kc}
out vec3 ray;
out float occlusion;
flat out vec3 normal;
flat out uvec2 about;                 // material, and bit 0: cut, bit 1: top, bit 2: along x
flat out float scale;
uniform float pixel;                  // its angle

void main() {
  Corner c = unpackCorner(0.4 * pixel);
  ray = c.position;
  normal = c.normal;
  occlusion = c.occlusion / 3.0;
  scale = c.scale;
  about = uvec2(c.material, (c.cut ? 1u : 0u));
  gl_Position = viewProjection * vec4(c.position, 1.0);
}
`,Mw=`${_i}${Uc}${Fc}${Oc}${Lf}${Pf}
uniform vec3 eye;
uniform sampler2D materials;          // two texels each: colour and kind; colour below, and whether flowers grow
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
  // Under a tree or a ledge some light comes from the sides; deep in a cave none does.
  float open = 1.0 - smoothstep(0.0, 1.6 * scale, roof) * mix(0.5, 1.0, smoothstep(5.0, 26.0, roof));
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
  if (isBeyondHorizon(ray)) discard;
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
    // Here and there a flower, in drifts of one colour.
    float meadow = smoothstep(0.45, 0.75, mid) * second.a;
    if (top && scale < 1.5 && own > 1.0 - 0.26 * meadow) {
      ivec2 bloom = texel - ivec2(floor(vec2(hash2(worldVoxel.xz), hash2(worldVoxel.zx + 9)) * 9.0 + 1.0)) - ivec2(floor(uv)) * 12;
      if (all(greaterThanEqual(bloom, ivec2(0))) && all(lessThan(bloom, ivec2(2)))) {
        float colour = noise(p.xz + 211.0, 5);
        vec3 petals = colour < 0.4 ? vec3(0.85, 0.62, 0.06) : colour < 0.52 ? vec3(0.8, 0.8, 0.75) : colour < 0.62 ? vec3(0.55, 0.08, 0.06) : vec3(0.3, 0.2, 0.6);
        albedo = mix(albedo, petals, grainy);
      }
    }
    swing = 0.07;
    through = 0.06;
  } else if (kind == SAND) {
    float ripple = sin((p.x * 0.8 + p.z * 0.35 + mid * 9.0) * 2.6);
    albedo *= 0.93 + 0.12 * broad + 0.025 * ripple * grainy;
    albedo *= 1.0 + grainy * (speck - 0.5) * 0.14;
    swing = 0.03;
  } else if (kind == SNOW) {
    albedo *= 0.92 + 0.08 * broad;
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
  if (kind == LEAVES) open = mix(open, 1.0, 0.4);
  // A trunk stands under its own crown, which heights take for a roof.
  if (kind == WOOD) open = mix(open, 1.0, 0.5);
  float corner = mix(0.42, 1.0, occlusion * (0.35 + 0.65 * occlusion));
  if (cut) corner = 1.0;
  // Faces of voxels stand in for a rough surface: far away its lean shows, not its steps.
  // By distance alone, as the corners too: by the size of voxels shade would jump where a coarser level begins.
  vec3 lean = slope.y > 1e5 ? normal : normalize(vec3(-slope.x, 1.0, -slope.y));
  float rough = smoothstep(24.0, 190.0, distance) * 0.85;
  vec3 shading = normalize(mix(normal, lean, rough));
  // A cut is a plane, although it is made of steps.
  if (cut) shading = normalize(vec3(slice.x, 0.55, slice.y));
  corner = mix(corner, 1.0, rough * 0.55);
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
  // A cut below a river is seen through no water.
  float under = cut ? 0.0 : column.y - p.y;
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
    float wet = 1.0 - smoothstep(0.3, 1.5, abs(p.y - seaLevel));
    colour *= 1.0 - 0.16 * wet;
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
`,yw=`${_i}${kc}
void main() {
  Corner c = unpackCorner(0.0);
  gl_Position = viewProjection * vec4(c.position, 1.0);
}
`,Ew=`${_i}
void main() {}
`,If=.14;function bw(i,t){const e=t+If;return{under:i(t)&&i(e),close:i(e-.5)!==i(e+.5)}}const Tw=`${_i}${kc}
out vec3 ray;
flat out vec3 normal;
flat out float scale;
flat out uint material;

void main() {
  Corner c = unpackCorner(0.0);         // what is seen through must not overlap
  ray = c.position;
  // The surface lies a little below its voxel's top, at every level of detail alike.
  if (c.normal.y > 0.5) ray.y -= ${If};
  normal = c.normal;
  scale = c.scale;
  material = c.material;
  gl_Position = viewProjection * vec4(ray, 1.0);
}
`,Aw=`${_i}${Uc}${Fc}${Oc}${Lf}${Pf}
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

/** The surface from under water: the sky, bent by the waves, in a round window; beyond its rim it mirrors the water. */
vec3 fromBelow(vec3 p, vec2 waves, vec3 toEye, float distance) {
  float near = 1.0 - smoothstep(20.0, 90.0, distance);
  vec2 drift = vec2(4.2, 2.1) * time;
  vec2 a = p.xz * 4.0 + drift;
  vec2 b = p.xz * 4.0 - drift.yx;
  float ripple = noise(a, 3) + noise(b, 3) - 1.0;
  vec2 ripples = vec2(noise(a + 1.5, 3) - noise(a - 1.5, 3), noise(b + 1.5, 3) - noise(b - 1.5, 3));
  // Steeper than seen from above, where the sky hides how flat they are.
  vec2 slope = waves * 3.0 + ripples * 0.16 * near;
  vec3 n = normalize(vec3(slope.x, -1.0, slope.y));
  float facing = max(dot(n, toEye), 0.0);
  float window = smoothstep(0.63, 0.75, facing);
  // Light that the waves gather: bright threads, as on the bed.
  float threads = pow(1.0 - min(abs(ripple) * 1.1, 1.0), 5.0) * (0.25 + 0.75 * near);
  vec3 mirrored = waterColour(reflect(-toEye, n)) * (0.8 + 0.5 * ripple) + waterFog.rgb * threads * 0.9;
  vec3 through = refract(-toEye, n, 1.333);
  vec3 sky = vec3(0.0);
  if (window > 0.0 && through.y > 0.0) {
    vec2 at = p.xz + through.xz * (CLOUD_HEIGHT - p.y) / (through.y + 0.09);
    float cloud = smoothstep(0.58 - cloudCover * 0.25, 0.74 - cloudCover * 0.25, cloudNoise(at));
    float toSun = max(dot(through, sunDirection), 0.0);
    sky = mix(skyColour(through), sunLight * 0.3 + skyLight * 0.4, cloud * 0.8) * (0.85 + 0.3 * threads);
    sky += sunLight * (pow(toSun, 400.0) * 8.0 + pow(toSun, 24.0) * 0.5) * (1.0 - 0.8 * cloud);
  }
  // The rim gathers all of the horizon.
  return mix(mirrored, sky, window) + horizon * 0.35 * window * (1.0 - smoothstep(0.7, 0.8, facing));
}

void main() {
  if (slice.w > 0.5 && dot(ray.xz, slice.xy) > slice.z + 0.5 * scale) discard;
  if (isBeyondHorizon(ray)) discard;
  vec3 p = ray + eye;
  float distance = length(ray);
  vec3 toEye = -ray / max(distance, 0.001);
  vec4 first = texelFetch(materials, ivec2(0, int(material)), 0);
  bool top = normal.y > 0.5;
  vec2 slope = top ? slopeOf(p.xz, distance) : vec2(0.0);
  if (waterFog.w > 0.5) {
    // Sides let the air behind them through.
    vec3 seen = top ? fromBelow(p, slope, toEye, distance) : waterColour(-toEye) * 1.2;
    result = vec4(display(throughAir(seen, ray, eye)), top ? 0.92 : 0.35);
    return;
  }
  vec3 n = top ? normalize(vec3(-slope.x, 1.0, -slope.y)) : normal;
  float facing = max(dot(n, toEye), 0.0);
  float mirror = 0.02 + 0.98 * pow(1.0 - facing, 5.0);
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
  float alpha = 1.0 - (1.0 - mirror) * (1.0 - murk);
  vec3 colour = (seen * mirror + body * (1.0 - mirror) * murk) / alpha;
  colour += sunLight * glint * lit * mirror * 6.0;
  vec3 white = (sunLight * 0.7 * lit * max(sunDirection.y, 0.0) + skyLight) * 0.75;
  colour = mix(colour, white, foam * 0.7);
  alpha = max(alpha, foam * 0.7);
  alpha = mix(alpha, 1.0, smoothstep(0.3, 1.0, distance / horizonBlocks));
  result = vec4(display(throughAir(colour, ray, eye)), alpha);
}
`;class Rw{size=0;lowest=0;rows=[];get(t){const e=t-this.lowest;return e>=0&&e<this.rows.length?this.rows[e]:void 0}set(t,e){for(this.size===0&&(this.rows.length=0,this.lowest=t);t<this.lowest;)this.rows.unshift(void 0),this.lowest--;for(;t>this.lowest+this.rows.length;)this.rows.push(void 0);this.get(t)===void 0&&this.size++,this.rows[t-this.lowest]=e}delete(t){this.get(t)!==void 0&&(this.rows[t-this.lowest]=void 0,this.size--)}values(){return this.rows.filter(t=>t!==void 0)}}const Xn=-32768;class Cw{constructor(t,e){this.column=t,this.y=e}payload=null;hash=null;material=null;arrived=0;known=0;meshedWith=-1;meshedSlice=null;changed=!1;hurried=!1;job=null;queued=!1;order=0;left=!1;drawable=null;tops=null;liquidTops=null;get lod(){return this.column.lod}get x(){return this.column.x}get z(){return this.column.z}}class Lw{constructor(t,e,n){this.lod=t,this.x=e,this.z=n,this.near[4]=this}chunks=new Rw;near=Array.from({length:9});around=0;wanted=!1;drawn=!1;coveredIn=0;ready=!1;begun=!1;heights=null;liquids=null;lowest=-32768;slots=[];bottom=1/0;top=-1/0;left=0;cut=!1;skirts=0;findSkirts(){const{near:t}=this;this.skirts=(t[3]?.drawn?0:1)|(t[1]?.drawn?0:2)|(t[5]?.drawn?0:4)|(t[7]?.drawn?0:8)}gather(){this.slots.length=0,this.bottom=1/0,this.top=-1/0;for(const{drawable:t}of this.chunks.values())t!==null&&(this.slots.push(t.slot),this.bottom=Math.min(this.bottom,t.bottom),this.top=Math.max(this.top,t.top))}}class Pw{constructor(t){this.size=t,this.free=[{first:0,count:t}]}free;get freeRows(){return this.free.reduce((t,e)=>t+e.count,0)}take(t){for(let e=0;e<this.free.length;e++){const n=this.free[e];if(n.count<t)continue;const s=n.first;return n.first+=t,n.count-=t,n.count===0&&this.free.splice(e,1),s}return-1}give(t,e){let n=this.free.findIndex(a=>a.first>t);n<0&&(n=this.free.length);const s=this.free[n-1],r=this.free[n];s!==void 0&&s.first+s.count===t?(s.count+=e,r!==void 0&&s.first+s.count===r.first&&(s.count+=r.count,this.free.splice(n,1))):r!==void 0&&t+e===r.first?(r.first=t,r.count+=e):this.free.splice(n,0,{first:t,count:e})}}const Vn=128,Xl=2048,Ta=Vn*Xl,Iw=Ta*8;function Dw(){const i=new Uint32Array(Ta*6);for(let t=0,e=0;t<Ta;t++){const n=t*4;i[e++]=n,i[e++]=n+1,i[e++]=n+2,i[e++]=n,i[e++]=n+2,i[e++]=n+3}return new on(i,1)}class Nw extends Nn{isBatchedMesh=!0;_colorsTexture=null;_multiDrawInstances=null;_multiDrawStarts=new Int32Array(1024);_multiDrawCounts=new Int32Array(1024);_multiDrawCount=0;constructor(t,e){super(t,e),this.frustumCulled=!1,this.matrixAutoUpdate=!1}empty(){this._multiDrawCount=0}push(t,e){const n=this._multiDrawCount;if(n>0&&this._multiDrawStarts[n-1]/24+this._multiDrawCounts[n-1]/6===t){this._multiDrawCounts[n-1]+=e*6;return}if(n===this._multiDrawStarts.length){const s=new Int32Array(n*2);s.set(this._multiDrawStarts),this._multiDrawStarts=s;const r=new Int32Array(n*2);r.set(this._multiDrawCounts),this._multiDrawCounts=r}this._multiDrawStarts[n]=t*24,this._multiDrawCounts[n]=e*6,this._multiDrawCount=n+1}}class Uw{constructor(t){this.renderer=t,this.geometry.setIndex(Dw()),this.addPage()}pages=[];geometry=new Fn;get bytes(){return this.pages.length*Iw+Ta*24}add(t){const e=Math.ceil(t.length/2/Vn);let n=0,s=-1;for(;n<this.pages.length&&(s=this.pages[n].ranges.take(e),!(s>=0));n++);return s<0&&(n=this.pages.length,this.addPage(),s=this.pages[n].ranges.take(e)),this.upload(this.pages[n].texture,s,e,t),{page:n,firstQuad:s*Vn,rows:e}}remove(t){this.pages[t.page].ranges.give(t.firstQuad/Vn,t.rows)}dispose(){for(const t of this.pages)t.texture.dispose();this.geometry.dispose()}addPage(){const t=new Ha(null,Vn,Xl,za,ln);t.internalFormat="RG32UI",t.minFilter=t.magFilter=xe,t.source.dataReady=!1,t.needsUpdate=!0,this.pages.push({texture:t,ranges:new Pw(Xl)})}upload(t,e,n,s){const r=Bc(this.renderer,t),a=Math.floor(s.length/2/Vn),o=Vn*2;a>0&&r.texSubImage2D(r.TEXTURE_2D,0,0,e,Vn,a,r.RG_INTEGER,r.UNSIGNED_INT,s,0);const l=s.length/2-a*Vn;n>a&&r.texSubImage2D(r.TEXTURE_2D,0,0,e+a,l,1,r.RG_INTEGER,r.UNSIGNED_INT,s,a*o)}}function Bc(i,t,e=3553){const n=i.getContext();i.initTexture(t);const{__webglTexture:s}=i.properties.get(t);i.state.activeTexture(n.TEXTURE0),i.state.bindTexture(e,s);const r=i.state,a=r.pixelStorei?.bind(r)??n.pixelStorei.bind(n);return a(n.UNPACK_FLIP_Y_WEBGL,!1),a(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),a(n.UNPACK_ALIGNMENT,1),n}const Df=uf.toHalfFloat(-2048),Ys=2047,Fw=Uint16Array.from({length:2*Ys+1},(i,t)=>uf.toHalfFloat(t-Ys)),Ow=4;class kw{constructor(t,e,n,s){this.renderer=t,this.levels=n,this.base=s,this.size=mu(e);const r=new Pc(null,this.size,this.size,n);r.format=vi,r.type=xn,r.internalFormat="RG16F",r.minFilter=r.magFilter=Fe,r.wrapS=r.wrapT=va,r.source.dataReady=!1,r.needsUpdate=!0,this.texture=r,this.clear()}texture;size;part=new Uint16Array(1024*2);isFor(t,e,n){return this.size===mu(t)&&this.levels===e&&this.base===n}get bytes(){return this.size*this.size*this.levels*Ow}set(t){if(t.lod>=this.levels)return;const e=this.base>>t.lod,{heights:n,liquids:s}=t;for(let o=0;o<1024;o++)this.part[2*o]=gu(n?.[o]??Xn,e),this.part[2*o+1]=gu(s?.[o]??Xn,e);const r=this.size/32,a=o=>(o%r+r)%r*32;this.write(a(t.x),a(t.z),t.lod,32,32,this.part)}clear(){const t=new Uint16Array(this.size*64*2).fill(Df);for(let e=0;e<this.levels;e++)for(let n=0;n<this.size;n+=64)this.write(0,n,e,this.size,64,t)}dispose(){this.texture.dispose()}write(t,e,n,s,r,a){const o=Bc(this.renderer,this.texture,35866);o.texSubImage3D(o.TEXTURE_2D_ARRAY,0,t,e,n,s,r,1,o.RG,o.HALF_FLOAT,a)}}const mu=i=>(2*i+3)*32<=1024?1024:2048;function gu(i,t){return i===Xn?Df:Fw[Math.min(Math.max(i-t,-Ys),Ys)+Ys]}const Bw=`
precision highp float;
uniform mat4 viewProjection;
uniform vec3 low;
uniform vec3 size;
uniform float thickness;
in vec3 corner;
in vec3 offset;
void main() {
  // A little outside of the voxels' faces, so that both do not fight for the same pixels.
  vec3 outward = (corner * 2.0 - 1.0) * 0.004;
  gl_Position = viewProjection * vec4(low + corner * size + outward + offset * thickness, 1.0);
}
`,zw=`
precision highp float;
uniform vec4 colour;
out vec4 result;
void main() { result = colour; }
`,Nf=i=>[i&1,i>>1&1,i>>2&1],Uf=[0,2,1,1,2,3,4,5,6,5,7,6,0,1,4,1,5,4,2,6,3,3,6,7,0,4,2,2,4,6,1,3,5,3,7,5];function Ff(i,t,e){const n=new Fn;return n.setAttribute("position",new on(new Float32Array(i.length),3)),n.setAttribute("corner",new on(new Float32Array(i),3)),n.setAttribute("offset",new on(new Float32Array(t),3)),n.setIndex(e),n}function Gw(){const i=Array.from({length:8},(t,e)=>Nf(e)).flat();return Ff(i,new Array(24).fill(0),Uf)}function Hw(){const[i,t,e]=[[],[],[]];for(let n=0;n<3;n++)for(let s=0;s<4;s++){const r=i.length/3;for(let a=0;a<8;a++){const[o,l,c]=Nf(a),h=[s&1,s>>1],u=[o,l,c].map((d,f)=>f===n?d:h[f===(n+1)%3?0:1]);i.push(...u),t.push(2*o-1,2*l-1,2*c-1)}e.push(...Uf.map(a=>r+a))}return Ff(i,t,e)}class Vw{scene=new $s;box;colours=[new Gt,new Gt];parts;constructor(t){this.box={viewProjection:t,low:{value:new F},size:{value:new F},thickness:{value:.01}},this.parts=[Gw(),Hw()].map(e=>{const n={...this.box,colour:{value:[1,1,1,1]}},s=new rs({glslVersion:Li,vertexShader:Bw,fragmentShader:zw,uniforms:n,transparent:!0,depthWrite:!1}),r=new Nn(e,s);return r.frustumCulled=!1,this.scene.add(r),r})}draw(t,e,n,s){const{first:r,last:a}=n,o=this.box.low.value,l=this.box.size.value;o.set(r.x-s.x,r.y-s.y,r.z-s.z),l.set(a.x+1-r.x,a.y+1-r.y,a.z+1-r.z),this.box.thickness.value=.006+.0014*Math.hypot(o.x+l.x/2,o.y+l.y/2,o.z+l.z/2),[n.colour,n.edge].forEach((c,h)=>{const{r:u,g:d,b:f}=this.colours[h].setHex(c,qn);this.parts[h].material.uniforms.colour.value=[u,d,f,h===0?n.veil:.95]}),t.render(this.scene,e)}dispose(){for(const{geometry:t,material:e}of this.parts)t.dispose(),e.dispose()}}const Ww=[["leaves|needles|bush|hedge|foliage","leaves"],["wood|bark|log|trunk|timber|plank","wood"],["\\bice\\b|glacier","ice"],["snow|firn","snow"],["\\bore\\b|coal|copper|silver|gold|iron\\b|crystal","ore"],["scree|gravel|shingle|pebble|rubble|cobble|talus","rubble"],["sandstone|limestone","rock"],["beach|desert$|\\bsand\\b|dune|sea floor","sand"],["grass|meadow|forest|jungle|taiga|tundra|savanna|moss|turf|heath|steppe|prairie|cactus","turf"],["soil|dirt|earth|clay|mud|peat|loam|humus","earth"]],Xw=[{look:"turf",grey:.18,times:[.95,.9,.86]},{look:"wood",grey:.3,times:[1.1,1.1,1.1]},{look:"snow",grey:0,times:[.8,.83,.87]}],qw=[{at:-.3,sunLight:["#a9c0ff",.34],skyLight:["#3a5090",.7],zenith:["#04081a",1],horizon:["#0f1c38",1],glow:["#000000",0],exposure:2.1},{at:-.14,sunLight:["#a9c0ff",.2],skyLight:["#7078a8",1.25],zenith:["#0a1436",1],horizon:["#2c3a68",.9],glow:["#a0483a",.45],exposure:2},{at:-.03,sunLight:["#ff8a4a",.1],skyLight:["#8088b8",.85],zenith:["#1c3070",1],horizon:["#7d7090",.75],glow:["#ff6e32",1.35],exposure:1.7},{at:.06,sunLight:["#ff9a52",2.3],skyLight:["#8c98c8",.85],zenith:["#34589e",1],horizon:["#cbaaa4",.82],glow:["#ff8a3c",1.3],exposure:1.25},{at:.22,sunLight:["#ffc58a",3.7],skyLight:["#9db0d4",1.05],zenith:["#3a74c4",1],horizon:["#e2d8d4",1.05],glow:["#ffb870",.7],exposure:.9},{at:.5,sunLight:["#ffe6c2",4.3],skyLight:["#a2bade",1.4],zenith:["#3b7dd6",1.05],horizon:["#cfe2f2",1.3],glow:["#ffe2b8",.35],exposure:.75},{at:1,sunLight:["#fff2dc",4.6],skyLight:["#a2bade",1.55],zenith:["#3879d6",1.1],horizon:["#c6def4",1.45],glow:["#fff0d8",.25],exposure:.69}],zc={looks:Ww,tints:Xw,light:qw},$w=zc.light,Yw=zc.looks.map(([i,t])=>[new RegExp(i),t]),Kw=new Map(zc.tints.map(({look:i,grey:t,times:e})=>[i,{grey:t,times:e}])),bs=([i,t])=>{const e=new Gt(i);return[e.r*t,e.g*t,e.b*t]},Dr=$w.map(({at:i,exposure:t,...e})=>({at:i,exposure:t,sunLight:bs(e.sunLight),skyLight:bs(e.skyLight),zenith:bs(e.zenith),horizon:bs(e.horizon),glow:bs(e.glow)})),Ts=(i,t,e)=>new F(...i.map((n,s)=>n+(t[s]-n)*e)),As=(i,t,e)=>{const n=Math.min(Math.max((e-i)/(t-i),0),1);return n*n*(3-2*n)};function vu(i){const t=(i-6)/24*2*Math.PI,e=.55,n=new F(Math.cos(t),Math.sin(t)*Math.cos(e),Math.sin(t)*Math.sin(e)).normalize(),s=new F(-n.x,-n.y*.9,n.z*.2+.35).normalize(),r=n.y;let a=0;for(;a<Dr.length-2&&r>Dr[a+1].at;)a++;const o=Dr[a],l=Dr[a+1],c=Math.min(Math.max((r-o.at)/(l.at-o.at),0),1),h=r>-.05,u=h?As(-.05,.03,r):As(-.05,-.16,r),d=h?n.clone():s.clone();d.y=Math.max(d.y,.035),d.normalize();const f=Ts(o.sunLight,l.sunLight,c).multiplyScalar(u),m=Ts(o.skyLight,l.skyLight,c),x=new Dt().setFromMatrix4(new Qt().makeRotationAxis(new F(0,Math.sin(.7),Math.cos(.7)).normalize(),-t));return{direction:d,sun:n,moon:s,sunLight:f,skyLight:m,groundLight:m.clone().multiply(new F(.42,.36,.28)).addScaledVector(new F(f.x*.075,f.y*.065,f.z*.045),Math.max(d.y,0)+.2),zenith:Ts(o.zenith,l.zenith,c),horizon:Ts(o.horizon,l.horizon,c),glow:Ts(o.glow,l.glow,c),exposure:o.exposure+(l.exposure-o.exposure)*c,stars:As(-.1,-.25,r),night:As(0,-.18,r),mist:3e-4+.0016*(1-As(.08,.4,Math.abs(r))),starTurn:x}}const Zw=1024,Vs=65536,Jw=[{axis:0,sign:-1},{axis:2,sign:-1},{axis:1,sign:1},{axis:0,sign:1},{axis:2,sign:1},{axis:1,sign:-1}],[Qw,jw,Tb,tS,eS]=[0,1,2,3,4,5],nS=[Qw,jw,tS,eS],iS=Jw.length+nS.length,_u=32,sS=(i,t,e)=>(t*_u+e)*_u+i,Nr=(i,t,e)=>(t-i.x)*i.nx+(e-i.z)*i.nz;function ql(i,t,e,n){const s=[Nr(i,t,e),Nr(i,t+n,e),Nr(i,t,e+n),Nr(i,t+n,e+n)];return Math.max(...s)<=0?"kept":Math.min(...s)>=0?"gone":"cut"}const xu=16,$l=0,Yl=1,la=2,Kl=13,Zl=14;class rS{values=new Int32Array(Vs*xu);at(t){return t*xu}set(t,{page:e,firstQuad:n},{counts:s},r,a){const o=this.at(t);this.values[o+$l]=e,this.values[o+Yl]=n,this.values.set(s,o+la),this.values[o+Kl]=r,this.values[o+Zl]=a}}const Rs=256,Ao=4096;function wu(i){const t=i.elements,e=new Float64Array(24);for(let n=0;n<6;n++){const s=n>>1,r=n&1?-1:1;for(let a=0;a<4;a++)e[n*4+a]=t[a*4+3]+r*t[a*4+s]}return e}class aS{constructor(t,e){this.renderer=t,this.makeMaterial=e,this.pages=new Uw(t),this.slots=new Ha(this.slotData,Rs,Vs/Rs,an,rn),this.slots.minFilter=this.slots.magFilter=xe,this.slots.needsUpdate=!0;for(const n of[this.solid,this.liquid,this.shadow])n.matrixWorldAutoUpdate=!1;this.addPage()}solid=new $s;liquid=new $s;shadow=new $s;slots;anchor={x:0,y:0,z:0};meshes=0;quads=0;lowest=1/0;highest=-1/0;pages;slotData=new Float32Array(Vs*4);staleSlotRows=new Set;table=new rS;used=[];freeSlots=[];sets=[];get bytes(){return this.pages.bytes+Vs*16}takeSlot(t,e,n,s){const r=this.freeSlots.pop()??this.used.length;if(r>=Vs)throw new Error("the view has more meshes than there are slots; make it smaller");return this.used[r]={lod:t,x:e,y:n,z:s},this.writeSlot(r),this.staleSlotRows.add(Math.floor(r/Rs)),r}uploadSlots(){if(this.staleSlotRows.size===0)return;const t=Bc(this.renderer,this.slots);for(const e of this.staleSlotRows)t.texSubImage2D(t.TEXTURE_2D,0,0,e,Rs,1,t.RGBA,t.FLOAT,this.slotData,e*Rs*4);this.staleSlotRows.clear()}freeSlot(t){this.used[t]=null,this.freeSlots.push(t)}add(t,e){const n=this.pages.add(e.quads);for(;this.sets.length<=n.page;)this.addPage();const{lod:s,y:r}=this.used[t],a=2**s,o=e.quads.length/2;this.meshes++,this.quads+=o;const[l,c]=[(r*32+e.low)*a,(r*32+e.high+1)*a];return this.lowest=Math.min(this.lowest,l),this.highest=Math.max(this.highest,c),this.table.set(t,n,e,l,c),{slot:t,place:n,quads:o,bottom:l,top:c}}remove(t){this.pages.remove(t.place),this.freeSlot(t.slot),this.meshes--,this.quads-=t.quads}setAnchor(t,e,n){this.anchor={x:t,y:e,z:n};for(let s=0;s<this.used.length;s++)this.used[s]&&this.writeSlot(s);this.slots.needsUpdate=!0}list({columns:t,squares:e},n,s,r,a){for(const u of this.sets)u.solid.empty(),u.liquid.empty();const o=wu(s),{values:l}=this.table,[c,h]=[this.lowest-n.y,this.highest-n.y];for(let u=0;u<t.length;u++){const d=e[3*u+2],f=e[3*u]-n.x,m=e[3*u+1]-n.z;if(!Cs(o,f,c,m,d,h))continue;const x=t[u];if(r!==null&&ql(r,x.x*d,x.z*d,d)==="gone"||!Cs(o,f,x.bottom-n.y,m,d,x.top-n.y))continue;const p=a&&x.ready&&(x.lod>0||f*f+m*m>25600)?(x.lowest-6)*2**x.lod:-1/0;for(const S of x.slots){const T=this.table.at(S),M=l[T+Zl];if(M<p)continue;const A=l[T+Kl]-n.y,E=M-n.y;Cs(o,f,A,m,d,E)&&this.push(T,f,A,m,d,E,x.skirts)}}}listShadow(t,e,n,s,r){for(const l of this.sets)l.shadow.empty();const a=wu(n),{values:o}=this.table;for(const l of t){if(l.lod>1)continue;const c=32*2**l.lod,h=l.x*c-e.x,u=l.z*c-e.z;if(!(r!==null&&ql(r,l.x*c,l.z*c,c)==="gone")&&Cs(a,h,l.bottom-e.y,u,c,l.top-e.y))for(const d of l.slots){const f=this.table.at(d),[m,x]=[o[f+Kl],o[f+Zl]];if(l.ready&&x<(l.lowest-2)*2**l.lod||!Cs(a,h,m-e.y,u,c,x-e.y))continue;const g=this.sets[o[f+$l]].shadow;let p=o[f+Yl];for(let S=0;S<6;S++){const T=S===0?s.x<0:S===3?s.x>0:S===1?s.z<0:S===4?s.z>0:S===2,M=o[f+la+S];T&&M>0&&g.push(p,M),p+=M}}}}get isListed(){return this.sets.some(({solid:t,liquid:e})=>t._multiDrawCount+e._multiDrawCount>0)}dispose(){this.pages.dispose(),this.slots.dispose();for(const{solid:t,liquid:e,shadow:n}of this.sets)for(const s of[t,e,n])s.material.dispose()}push(t,e,n,s,r,a,o){const{values:l}=this.table,c=this.sets[l[t+$l]];let h=l[t+Yl];for(let d=0;d<10;d++){const f=l[t+la+d];if(f>0){const m=d<6?d:d-6<2?d-6:d-5;(m===0?e+r>0:m===3?e<0:m===1?s+r>0:m===4?s<0:m===2?n<0:a>0)&&(d<6||o>>d-6&1)&&c.solid.push(h,f),h+=f}}const u=l[t+la+iS];u>0&&c.liquid.push(h,u)}addPage(){const t=this.sets.length,e=(n,s)=>{const r=this.makeMaterial(n);r.uniforms.quads={value:this.pages.pages[t].texture},r.uniforms.slots={value:this.slots};const a=new Nw(this.pages.geometry,r);return s.add(a),a};this.sets.push({solid:e("solid",this.solid),liquid:e("liquid",this.liquid),shadow:e("shadow",this.shadow)})}writeSlot(t){const{lod:e,x:n,y:s,z:r}=this.used[t],a=2**e;this.slotData[t*4]=n*32*a-this.anchor.x,this.slotData[t*4+1]=s*32*a-this.anchor.y,this.slotData[t*4+2]=r*32*a-this.anchor.z,this.slotData[t*4+3]=a}}function Cs(i,t,e,n,s,r){for(let a=0;a<24;a+=4){const o=i[a],l=i[a+1],c=i[a+2];if(o*(o>0?t+s:t)+l*(l>0?r:e)+c*(c>0?n+s:n)+i[a+3]<0)return!1}return!0}const Su=new F(1e9,1e9,1e9),Mu=.12,oS=.03;let lS=class{renderer;terrain;ground=null;light=vu(10);triangles=0;drawCalls=0;camera=new pn(70,1,Mu,8e3);viewProjection=new Qt;sky=new $s;uniforms;shadowUniforms;shadowTarget=null;shadowCentre=new F(1/0,0,0);shadowDirection=new F;shadowMatrix=new Qt;shadowAt=-1/0;shadowStale=!0;shadowReach=0;skyMaterial;marker;disposed=!1;constructor(t,e){this.renderer=new _w({canvas:t,antialias:e==="high",powerPreference:"high-performance",stencil:!1,alpha:!1}),this.renderer.autoClear=!1,this.renderer.sortObjects=!1,this.renderer.info.autoReset=!1,this.renderer.debug.checkShaderErrors=!1,this.uniforms={eye:{value:new F},viewProjection:{value:this.viewProjection},pixel:{value:.001},inverseViewProjection:{value:new Qt},anchor:{value:new Kt},materials:{value:null},ground:{value:null},viewCentre:{value:new Kt},level0Reach:{value:400},levels:{value:1},groundBase:{value:0},shadowMap:{value:null},shadowMatrix:{value:new Qt},shadowReach:{value:0},marchSteps:{value:12},slice:{value:new de},time:{value:0},detail:{value:1},borders:{value:0},selected:{value:Su.clone()},sunDirection:{value:new F},sunLight:{value:new F},skyLight:{value:new F},groundLight:{value:new F},zenith:{value:new F},horizon:{value:new F},glow:{value:new F},glowDirection:{value:new F},moonDirection:{value:new F},horizonBlocks:{value:4096},fogDensity:{value:1},mist:{value:0},seaLevel:{value:0},waterFog:{value:new de},cloudCover:{value:.5},cloudShift:{value:new Kt},exposure:{value:1},nightly:{value:0},stars:{value:0},starTurn:{value:new Dt},sunDisc:{value:1}},this.marker=new Vw(this.uniforms.viewProjection),this.shadowUniforms={eye:{value:new F},viewProjection:{value:new Qt}},this.terrain=new aS(this.renderer,r=>this.makeMaterial(r)),this.skyMaterial=new rs({glslVersion:Li,vertexShader:xw,fragmentShader:ww,uniforms:this.uniforms,depthWrite:!1});const n=new Fn;n.setAttribute("position",new on(new Float32Array(9),3));const s=new Nn(n,this.skyMaterial);s.frustumCulled=!1,this.sky.add(s),this.setQuality(e),this.warmUp()}async warmUp(){const t=[this.terrain.solid,this.sky,this.terrain.liquid],e=t.map(n=>this.renderer.compileAsync(n,this.camera));if(this.shadowReach>0&&(this.renderer.setRenderTarget(this.shadowTarget),t.push(this.terrain.shadow),e.push(this.renderer.compileAsync(this.terrain.shadow,this.camera)),this.renderer.setRenderTarget(null)),await Promise.all(e),!(this.disposed||this.renderer.getContext().isContextLost()))for(const n of t)n.traverse(s=>this.readProgram(s))}readProgram(t){const e=t.material;if(e===void 0)return;const{currentProgram:n}=this.renderer.properties.get(e);n?.getUniforms()}get gpuBytes(){const t=this.shadowTarget===null?0:this.shadowTarget.width**2*8;return this.terrain.bytes+(this.ground?.bytes??0)+t}setQuality(t){this.set("detail",t==="high"?1:0),this.set("marchSteps",t==="high"?14:8),this.shadowTarget?.depthTexture?.dispose(),this.shadowTarget?.dispose(),this.shadowTarget=null,this.shadowReach=t==="high"?120:0;const e=t==="high"?2048:1,n=new ki(e,e,ln);n.compareFunction=Rc,n.minFilter=n.magFilter=Fe,this.shadowTarget=new _n(e,e,{depthTexture:n,depthBuffer:!0,stencilBuffer:!1}),this.set("shadowMap",n),this.set("shadowReach",this.shadowReach),this.shadowStale=!0}setMaterials(t){this.uniforms.materials.value?.dispose(),this.set("materials",t)}setGround(t){this.ground?.dispose(),this.ground=t,this.set("ground",t?.texture??null),this.set("levels",t?.levels??1)}setReach(t,e,n,s){this.viewCentre.set(t,e),this.set("level0Reach",n),this.set("horizonBlocks",s),this.camera.far=s*1.6+1e3,this.camera.updateProjectionMatrix()}viewCentre=new Kt;setTimeOfDay(t){this.light=vu(t),this.shadowStale=!0}setBorders(t){this.set("borders",t?1:0)}setFov(t){this.camera.fov=t,this.camera.updateProjectionMatrix(),this.measurePixel()}resize(t,e,n){this.renderer.setPixelRatio(n),this.renderer.setSize(t,e,!1),this.camera.aspect=t/Math.max(e,1),this.camera.updateProjectionMatrix(),this.measurePixel()}measurePixel(){this.set("pixel",2*Math.tan(this.camera.fov*Math.PI/360)/Math.max(this.renderer.domElement.height,1))}contextRestored(){this.terrain.slots.needsUpdate=!0,this.ground=null,this.shadowStale=!0,this.shadowAt=-1/0}landChanged(){this.shadowStale=!0}draw(t){const{eye:e,columns:n,slice:s}=t;this.moveAnchor(e);const r=this.terrain.anchor,a=this.uniforms;if(a.eye.value.set(e.x-r.x,e.y-r.y,e.z-r.z),a.anchor.value.set(r.x%2**30,r.z%2**30),a.viewCentre.value.set(this.viewCentre.x-r.x,this.viewCentre.y-r.z),this.set("groundBase",t.groundBase-r.y),this.set("seaLevel",(t.seaLevel??-1e6)-r.y),this.set("time",t.seconds%3600),a.cloudShift.value.set(t.seconds*2.2%131072,t.seconds*.9%131072),a.selected.value.copy(Su),t.selected){const{x:u,y:d,z:f}=t.selected;a.selected.value.set(u-r.x,d-r.y,f-r.z)}a.slice.value.set(s?.nx??0,s?.nz??0,s===null?0:(s.x-e.x)*s.nx+(s.z-e.z)*s.nz,s===null?0:1),this.applyLight(t.underWater);const l=t.closeToWater?oS:Mu;this.camera.near!==l&&(this.camera.near=l,this.camera.updateProjectionMatrix()),this.camera.rotation.set(e.pitch,-e.yaw,0,"YXZ"),this.camera.updateMatrixWorld(!0),this.viewProjection.multiplyMatrices(this.camera.projectionMatrix,this.camera.matrixWorldInverse),a.inverseViewProjection.value.copy(this.viewProjection).invert();const{renderer:c,terrain:h}=this;return h.list(n,e,this.viewProjection,s,t.hideBuried),t.onlyWithLand&&!h.isListed?!1:(c.info.reset(),h.uploadSlots(),this.castShadows(e,n.columns,t.now,s),c.setRenderTarget(null),c.clear(!0,!0,!1),c.render(h.solid,this.camera),c.render(this.sky,this.camera),c.render(h.liquid,this.camera),t.marker!==null&&this.marker.draw(c,this.camera,t.marker,e),this.triangles=c.info.render.triangles,this.drawCalls=c.info.render.calls,!0)}dispose(){this.disposed=!0,this.terrain.dispose(),this.setGround(null),this.skyMaterial.dispose(),this.marker.dispose(),this.uniforms.materials.value?.dispose(),this.shadowTarget?.depthTexture?.dispose(),this.shadowTarget?.dispose(),this.renderer.dispose()}set(t,e){this.uniforms[t].value=e}makeMaterial(t){return t==="shadow"?new rs({glslVersion:Li,vertexShader:yw,fragmentShader:Ew,uniforms:{...this.shadowUniforms},side:mi,colorWrite:!1,polygonOffset:!0,polygonOffsetFactor:1.5,polygonOffsetUnits:2}):t==="liquid"?new rs({glslVersion:Li,vertexShader:Tw,fragmentShader:Aw,uniforms:{...this.uniforms},side:Ln,transparent:!0,forceSinglePass:!0}):new rs({glslVersion:Li,vertexShader:Sw,fragmentShader:Mw,uniforms:{...this.uniforms}})}moveAnchor(t){const e=this.terrain.anchor;if(Math.max(Math.abs(t.x-e.x),Math.abs(t.z-e.z),Math.abs(t.y-e.y))<=Ao)return;const s=r=>Math.round(r/Ao)*Ao;this.terrain.setAnchor(s(t.x),s(t.y),s(t.z))}applyLight(t){const e=this.light;for(const r of["sunLight","skyLight","groundLight","zenith","horizon","glow"])this.uniforms[r].value.copy(e[r]);this.uniforms.sunDirection.value.copy(e.direction),this.uniforms.glowDirection.value.copy(e.sun),this.uniforms.moonDirection.value.copy(e.moon),this.uniforms.starTurn.value.copy(e.starTurn),this.set("exposure",e.exposure),this.set("nightly",e.night),this.set("stars",e.stars),this.set("sunDisc",e.sun.y>-.05?1:0),this.set("mist",e.mist);const n=this.uniforms.waterFog.value,s=.52*(e.sunLight.y*.3+e.skyLight.y);n.set(.05*s,.42*s,.5*s,t?1:0)}castShadows(t,e,n,s){const r=this.shadowTarget;if(r===null)return;if(this.shadowReach===0){this.shadowStale&&this.renderer.initRenderTarget(r),this.shadowStale=!1;return}const a=this.light.direction;if(!(Math.hypot(t.x-this.shadowCentre.x,t.y-this.shadowCentre.y,t.z-this.shadowCentre.z)<24)||a.distanceToSquared(this.shadowDirection)>1e-6||this.shadowStale&&n-this.shadowAt>400){this.shadowStale=!1,this.shadowAt=n,this.shadowDirection.copy(a),this.shadowCentre.set(Math.floor(t.x),Math.floor(t.y),Math.floor(t.z));const u=this.shadowReach+28,d=new Qt().lookAt(a,new F,new F(0,1,.001)).setPosition(0,0,0).invert(),f=420,m=new Qt().makeOrthographic(-u,u,u,-u,-f,f);this.shadowMatrix.multiplyMatrices(m,d);const x=this.terrain.anchor;this.shadowUniforms.eye.value.set(this.shadowCentre.x-x.x,this.shadowCentre.y-x.y,this.shadowCentre.z-x.z),this.shadowUniforms.viewProjection.value.copy(this.shadowMatrix),this.terrain.listShadow(e,this.shadowCentre,this.shadowMatrix,a,s),this.renderer.setRenderTarget(r),this.renderer.clear(!1,!0,!1),this.renderer.render(this.terrain.shadow,this.camera)}const c=new Qt().makeScale(.5,.5,.5).setPosition(.5,.5,.5).multiply(this.shadowMatrix),h=new Qt().makeTranslation(t.x-this.shadowCentre.x,t.y-this.shadowCentre.y,t.z-this.shadowCentre.z);this.uniforms.shadowMatrix.value.multiplyMatrices(c,h)}};const cS={rock:0,turf:1,sand:2,snow:3,leaves:4,wood:5,ice:6,ore:7,rubble:8,earth:9};function hS(i){const t=i.name.toLowerCase();for(const[e,n]of Yw)if(e.test(t))return n;return"rock"}function uS(i,t){const e=Kw.get(t);if(e===void 0)return;const n=i.r*.32+i.g*.6+i.b*.08,[s,r,a]=e.times;i.lerp(new Gt().setRGB(n,n,n),e.grey),i.setRGB(i.r*s,i.g*r,i.b*a)}function dS(i){const t=new Float32Array(i.length*8),e=new Gt,n=new Gt(i.find(a=>/soil|dirt|earth/.test(a.name))?.colour??8018750),s=new Gt(i.find(a=>a.phase==="solid")?.colour??7762038);i.forEach((a,o)=>{const l=hS(a);e.set(a.colour),uS(e,l);const c=l==="ore"?s:/cactus/.test(a.name)?e:n;t.set([e.r,e.g,e.b,cS[l],c.r,c.g,c.b,/meadow|forest|grass|heath|taiga/.test(a.name)?1:0],o*8)});const r=new Ha(t,2,i.length,an,rn);return r.minFilter=r.magFilter=xe,r.needsUpdate=!0,r}const fS=32,pS=16,Ro=1024;class mS{version=-1;x=0;z=0;columns=[];squares=new Float64Array;unsorted=[];steps=[];ends=new Uint32Array(Ro);update(t,e,n,s){return e===this.version&&Math.abs(n-this.x)+Math.abs(s-this.z)<=fS?this:(this.version=e,this.x=n,this.z=s,this.sort(t),this.measure(),this)}sort(t){const{columns:e,unsorted:n,steps:s,ends:r}=this;r.fill(0);let a=0;for(const o of t){const l=this.stepOf(o);n[a]=o,s[a++]=l,r[l]++}for(let o=1;o<Ro;o++)r[o]+=r[o-1];e.length=n.length=a;for(let o=a-1;o>=0;o--)e[--r[s[o]]]=n[o]}measure(){const{columns:t}=this;this.squares.length<3*t.length&&(this.squares=new Float64Array(6*t.length));const{squares:e}=this;for(let n=0;n<t.length;n++){const{lod:s,x:r,z:a}=t[n],o=32*2**s;e[3*n]=r*o,e[3*n+1]=a*o,e[3*n+2]=o}}stepOf(t){const e=32*2**t.lod,n=Math.hypot((t.x+.5)*e-this.x,(t.z+.5)*e-this.z)-e/2;return Math.min(Ro-1,Math.max(0,Math.floor(n/pS)))}}class gS{constructor(t,e){this.predictions=t,this.client=e}async edit(t,e,n){const s=this.predictions.begin(n);try{const r=await t.edit(e);return this.predictions.settled(s,r.revision,r.changed>0),this.resolve(s),r}catch(r){throw this.predictions.refused(s),r}}async resolve(t){if(this.predictions.behind(t).length===0)return;const e=this.client();if(e!==null)try{await e.ping();for(const n of this.predictions.behind(t)){const s=await e.getChunk({lod:0,...n});if(e!==this.client())return;this.predictions.resolved(t,n,s.revision,s)}}catch{e===this.client()&&this.predictions.refused(t)}}}class At extends Error{constructor(t,e,n=0){super(e),this.kind=t,this.retryAfterMs=n}name="TalusError"}function qa(i,t){try{return t()}catch(e){throw e instanceof At?e:new At("out_of_range",`${i}: ${e.message}`)}}function Of(i){const t=globalThis.location;return t?.origin===void 0||t.host===new URL(i).host?"":`, or the server refuses pages of ${t.origin}: its setting http.origins lists the origins that may connect`}class vS{handlers=new Map;on(t,e){this.handlers.set(t,[...this.handlers.get(t)??[],e])}off(t,e){this.handlers.set(t,(this.handlers.get(t)??[]).filter(n=>n!==e))}emit(t,...e){for(const n of this.handlers.get(t)??[])try{n(...e)}catch(s){queueMicrotask(()=>{throw s})}}}const _S=6,Ws={first:0,last:-1};function Yn(i){return Math.max(0,i.last-i.first+1)}function Xs(i,t){return i.first<=t&&t<=i.last}function Ri(i,t){return{first:Math.max(i.first,t.first),last:Math.min(i.last,t.last)}}function Co(i,t,e){return{first:Math.floor((i-t)/e),last:Math.floor((i+t)/e)}}function yu(i,t,e){return{first:Math.ceil(i.first*t/e)+0,last:Math.floor((i.last+1)*t/e)-1}}function xS(i,t){const n=s=>Math.max(-68719476736,Math.min(68719476736,s));return{first:Math.floor((Math.floor(n(i.minY)/t)-1)/32),last:Math.floor(Math.floor((n(i.maxY)-1)/t)/32)}}function wS(i){const t=2**(31-i.lod),e={first:-t,last:t-1};return{lod:i.lod,x:Ri(i.x,e),y:Ri(i.y,e),z:Ri(i.z,e),innerX:Ri(i.innerX,e),innerZ:Ri(i.innerZ,e)}}function Eu(i){const t=Yn(Ri(i.x,i.innerX))*Yn(Ri(i.z,i.innerZ));return(Yn(i.x)*Yn(i.z)-t)*Yn(i.y)}function SS(i,t){const e=Math.floor(i.centre.x/32),n=Math.floor(i.centre.y/32),s=Math.floor(i.centre.z/32),r=(o,l)=>({lod:o,x:Co(e,l,2**o),y:Co(n,i.verticalRadius,2**o),z:Co(s,l,2**o),innerX:Ws,innerZ:Ws}),a=[r(0,i.horizontalRadius)];for(const o of i.rings??[]){const l=a[a.length-1],c=r(o.lod,o.radius),h=!i.horizon||a.length>1;a.push({...c,y:i.horizon?xS(t,2**o.lod):c.y,innerX:h?yu(l.x,2**l.lod,2**o.lod):Ws,innerZ:h?yu(l.z,2**l.lod,2**o.lod):Ws})}return a}class Aa{boxes;count;uncutCount;byLod=[];constructor(t,e={minY:0,maxY:0}){const n=SS(t,e);this.boxes=n.map(wS),this.count=this.boxes.reduce((s,r)=>s+Eu(r),0),this.uncutCount=n.reduce((s,r)=>s+Eu(r),0);for(const s of this.boxes)this.byLod[s.lod]=s}hasColumn(t,e,n){const s=this.byLod[t];return s!==void 0&&Lo(s,e,n)}covers(t){const e=this.byLod[t.lod];return e!==void 0&&Xs(e.y,t.y)&&Lo(e,t.x,t.z)}rows(t,e,n){return this.hasColumn(t,e,n)?this.byLod[t].y:Ws}forEachColumn(t){for(const e of this.boxes)if(Yn(e.y)!==0)for(let n=e.z.first;n<=e.z.last;++n)for(let s=e.x.first;s<=e.x.last;++s)Lo(e,s,n)&&t(e.lod,s,n,e.y)}forEach(t){this.forEachColumn((e,n,s,r)=>{for(let a=r.first;a<=r.last;++a)t({lod:e,x:n,y:a,z:s})})}}function Lo(i,t,e){return Xs(i.x,t)&&Xs(i.z,e)&&!(Xs(i.innerX,t)&&Xs(i.innerZ,e))}function Ks(i){throw new At("out_of_range",i)}function MS(i){for(const r of["x","y","z"])Number.isFinite(i.centre[r])||Ks(`the View's centre has ${r} = ${i.centre[r]}; it must be a finite number`);const t=(r,a)=>{(!Number.isInteger(r)||r<0||r>65535)&&Ks(`the View's ${a} is ${r}; it must be a whole number from 0 to 65535`)};t(i.horizontalRadius,"horizontalRadius"),t(i.verticalRadius,"verticalRadius");let e=0,n=i.horizontalRadius;for(const r of i.rings??[])t(r.radius,`radius of level ${r.lod}`),(!Number.isInteger(r.lod)||r.lod<=e||r.lod>_S||r.radius<=n)&&Ks(`the View's ring of level ${r.lod} and radius ${r.radius} does not grow from level ${e}, ${n}`),e=r.lod,n=r.radius;const s=r=>Math.max(-4503599627370496,Math.min(2**52,Math.floor(r)));return{centre:{x:s(i.centre.x),y:s(i.centre.y),z:s(i.centre.z)},...i.direction===void 0?{}:{direction:{...i.direction}},horizontalRadius:i.horizontalRadius,verticalRadius:i.verticalRadius,rings:(i.rings??[]).map(r=>({lod:r.lod,radius:r.radius})),horizon:i.horizon===!0}}function bu(i,t,e){const n=(s,r,a)=>{s>r&&Ks(`the View's ${a} is ${s}; this server allows ${r}`)};n(i.horizontalRadius,e.viewHorizontalRadius,"horizontalRadius"),n(i.verticalRadius,e.viewVerticalRadius,"verticalRadius");for(const s of i.rings??[])n(s.radius,e.viewHorizontalRadius*2**s.lod,`radius of level ${s.lod}`);n(t.uncutCount,e.viewChunks,"number of chunks"),i.horizon&&!e.viewHorizon&&Ks("the View has a horizon, which this server does not know")}const yS=6e4;function kf(i){return Math.max(0,Math.min(i,yS))}class ES{constructor(t={}){this.policy=t}failures=0;next(t=0){const{maxAttempts:e=1/0,firstDelayMs:n=500,maxDelayMs:s=1e4}=this.policy;if(++this.failures>e)return null;const r=Math.min(s,n*2**Math.min(this.failures-1,30));return Math.round(kf(t)+Math.random()*r)}reset(){this.failures=0}}function He(i){return`${i.lod}/${i.x}/${i.y}/${i.z}`}function bS(i,t){return i.x===t.x&&i.y===t.y&&i.z===t.z&&i.lod===t.lod}function Bf(i){const{lod:t,x:e,y:n,z:s}=qa("chunk",()=>({...i,lod:i.lod})),r=2**(31-t),a=l=>Number.isInteger(l)&&-r<=l&&l<r;if(!(Number.isInteger(t)&&t>=0&&t<=6&&a(e)&&a(n)&&a(s)))throw new At("out_of_range",`chunk ${He(i)} (level/x/y/z) lies in no world: levels are 0 to 6, coordinates whole and within 2^31 >> level`)}function zf(i){qa("columns",()=>{for(const{x:t,z:e}of i)if(!(Number.isSafeInteger(t)&&Number.isSafeInteger(e)))throw new At("out_of_range",`column ${t}, ${e}: its coordinates must be whole numbers`)})}const pi=i=>i.last<i.first;function Jl(i,t){return{first:Math.max(i.first,t.first),last:Math.min(i.last,t.last)}}function Ql(i,t){return pi(Jl(i,t))?pi(i)?[]:[i]:[{first:i.first,last:t.first-1},{first:t.last+1,last:i.last}].filter(n=>!pi(n))}function Ra(i,t){const e={x:Jl(i.x,t.x),z:Jl(i.z,t.z)};return pi(e.x)||pi(e.z)?[]:[e]}function jl(i,t){const[e]=Ra(i,t);return e===void 0?pi(i.x)||pi(i.z)?[]:[i]:[...Ql(i.z,e.z).map(n=>({x:i.x,z:n})),...Ql(i.x,e.x).map(n=>({x:n,z:e.z}))]}const tc=i=>({x:i.innerX,z:i.innerZ}),ec=i=>jl(i,tc(i));function TS(i,t){const e=jl(i,t),n=Ra(i,t).flatMap(s=>Ra(s,tc(t)));return[...e,...n].flatMap(s=>jl(s,tc(i)))}function AS(i,t){return ec(i).flatMap(e=>ec(t).flatMap(n=>Ra(e,n)))}function Gf(i,t){const e=[];for(const n of i.boxes){const{lod:s,y:r}=n;if(pi(r))continue;const a=t?.boxes.find(l=>l.lod===s),o=(l,c)=>{for(const{x:h,z:u}of l)e.push({lod:s,x:h,y:c,z:u})};if(a===void 0){o(ec(n),r);continue}o(TS(n,a),r);for(const l of Ql(r,a.y))o(AS(n,a),l)}return e}function Hf(i){return i.reduce((t,{x:e,y:n,z:s})=>t+Yn(e)*Yn(n)*Yn(s),0)}function Vf(i,t){for(const{lod:e,x:n,y:s,z:r}of i)for(let a=r.first;a<=r.last;++a)for(let o=n.first;o<=n.last;++o)for(let l=s.first;l<=s.last;++l)t({lod:e,x:o,y:l,z:a})}class RS{view=null;shape=null;delivered=new Map;replace(t,e){const n=this.shape;this.view=t,this.shape=t===null?null:new Aa(t,e);const s=[];if(n===null)return s;const r=Gf(n,this.shape);if(Hf(r)>this.delivered.size)for(const[a,{key:o}]of this.delivered)this.shape?.covers(o)||(this.delivered.delete(a),s.push(o));else Vf(r,a=>{this.delivered.delete(He(a))&&s.push(a)});return s}forget(){const t=[...this.delivered.values()].map(({key:e})=>e);return this.delivered.clear(),t}forgetRevisions(){for(const[t,e]of this.delivered)this.delivered.set(t,{...e,revision:-1n})}deliver(t){if(!this.shape?.covers(t.key))return!1;const e=He(t.key),n=this.delivered.get(e),{key:s,revision:r,hash:a,material:o}=t;if(n!==void 0){if(n.revision>r)return!1;const l=a!==null&&n.hash!==null?a===n.hash:CS(o,n.material);if(this.delivered.set(e,{key:s,revision:r,hash:a??(l?n.hash:null),material:o}),l)return!1}else this.delivered.set(e,{key:s,revision:r,hash:a,material:o});return!0}has(t){return this.delivered.has(He(t))}find(t){return this.delivered.get(He(t))}confirm(t,e){this.delivered.set(He(t.key),{...t,revision:e})}isWhole(){return this.delivered.size===(this.shape?.count??0)}missing(){const t=[];return this.isWhole()||this.shape?.forEach(e=>{this.has(e)||t.push(e)}),t}}function CS(i,t){return i!==null&&i===t}const LS=50,PS={chunks:0,uniformChunks:0,unchangedChunks:0,receivedBytes:0,sentBytes:0,chunkBytes:0,connections:0,requests:0,latencyMs:null,firstChunkMs:null,viewCompleteMs:null};class Wf{constructor(t){this.options=t,this.backoff=new ES(t.reconnect),globalThis.addEventListener?.("online",this.retryNow)}world=null;connected=!1;stats={...PS};tracker=new RS;backoff;isClosed=!1;events=new vS;closeError=null;wanted=null;viewTimer;retryTimer;appliedAt=-1/0;viewSince=0;on(t,e){return this.events.on(t,e),this}off(t,e){return this.events.off(t,e),this}emit(t,...e){this.events.emit(t,...e)}ready(){return new Promise((t,e)=>{if(this.connected&&this.world!==null){t(this.world);return}if(this.isClosed){e(this.closedError());return}const n=()=>{this.off("connected",s).off("closed",r)},s=a=>{n(),t(a)},r=()=>{n(),e(this.closedError())};this.on("connected",s).on("closed",r)})}closedError(){return this.closeError??new At("closed","the client is closed")}setView(t){if(this.isClosed)throw this.closedError();const e=t===null?null:qa("setView",()=>MS(t));e!==null&&this.world!==null&&bu(e,new Aa(e,this.world),this.world.limits),!DS(e,this.wanted)&&(this.wanted=e,this.applyViewSoon())}applyViewSoon(){if(!this.connected||this.viewTimer!==void 0)return;const t=this.appliedAt+LS-performance.now();if(t<=0){this.applyView();return}this.viewTimer=setTimeout(()=>{this.viewTimer=void 0,this.connected&&this.applyView()},t)}applyView(){const t=this.wanted,e=this.tracker.view;this.appliedAt=performance.now(),(e===null||t===null||!Xf(e,t))&&(this.viewSince=this.appliedAt,this.stats.firstChunkMs=this.stats.viewCompleteMs=null);for(const n of this.tracker.replace(t,this.world))this.emit("chunkLeft",n);this.connected&&this.tracker.view===t&&this.viewApplied()}joined(t){const e=this.world,n=e!==null&&e.fingerprint===t.fingerprint;if(n)e.storeId!==t.storeId&&this.tracker.forgetRevisions();else for(const s of this.tracker.forget())this.emit("chunkLeft",s);if(this.world=t,this.connected=!0,++this.stats.connections,this.worldKnown(n),this.emit("connected",t,e===null||n),!!this.connected){if(this.wanted!==null)try{bu(this.wanted,new Aa(this.wanted,t),t.limits)}catch(s){this.wanted=this.tracker.view=null,this.emit("error",s)}this.wanted!==null&&this.applyView()}}deliver(t){return this.tracker.deliver(t)?(++this.stats.chunks,t.material!==null&&++this.stats.uniformChunks,this.stats.firstChunkMs??=performance.now()-this.viewSince,this.emit("chunk",t),!0):!1}tellComplete(){this.tracker.view===this.wanted&&(this.stats.viewCompleteMs??=performance.now()-this.viewSince,this.emit("viewComplete",this.tracker.view))}lost(t){if(this.isClosed)return;this.connected=!1,clearTimeout(this.viewTimer),this.viewTimer=void 0;const e=typeof this.options.url!="string"&&this.options.url.length>1?0:t.retryAfterMs,s=t.kind==="refused"||t.kind==="broken_protocol"&&this.world===null?null:this.backoff.next(e);if(this.emit("disconnected",t,s),!this.isClosed){if(s===null){this.end(t);return}this.retryTimer=setTimeout(this.retryNow,s)}}retry(){this.retryNow()}retryNow=()=>{this.retryTimer!==void 0&&(clearTimeout(this.retryTimer),this.retryTimer=void 0,this.attempt())};end(t){this.isClosed||(this.isClosed=!0,this.connected=!1,this.closeError=t,clearTimeout(this.viewTimer),clearTimeout(this.retryTimer),this.retryTimer=void 0,globalThis.removeEventListener?.("online",this.retryNow),this.stopped(),this.emit("closed",t))}close(){this.end(null)}}function IS(i,t){return JSON.stringify(i.rings)===JSON.stringify(t.rings)}function Xf(i,t){const e=n=>Math.floor(n/32);return e(i.centre.x)===e(t.centre.x)&&e(i.centre.y)===e(t.centre.y)&&e(i.centre.z)===e(t.centre.z)&&i.horizontalRadius===t.horizontalRadius&&i.verticalRadius===t.verticalRadius&&i.horizon===t.horizon&&IS(i,t)}function DS(i,t){return i===null||t===null?i===t:Xf(i,t)&&NS(i.direction,t.direction)}function NS(i,t){if(i===void 0||t===void 0)return i===t;const e=Math.hypot(i.x,i.y,i.z)*Math.hypot(t.x,t.y,t.z);return!(e>0)||i.x*t.x+i.y*t.y+i.z*t.z>.97*e}function nr(i){const t=[3,0,1];let e=i;for(;e>=128;e>>=7)t.push(e&127|128);return t.push(e),Uint8Array.from(t)}function Zs(i){if(i.length<4||i.length>6||i[0]!==3||i[1]!==0||i[2]!==1)return null;let t=0;for(let n=3;n<i.length;++n)t|=(i[n]&127)<<7*(n-3);const e=nr(t&65535);return e.length===i.length&&e.every((n,s)=>n===i[s])?t:null}const Tu=1<<20,nc=65536;function bt(i){return new At("broken_protocol",`the server sent ${i}`)}class US{constructor(t){this.bytes=t,this.view=new DataView(t.buffer,t.byteOffset,t.byteLength)}view;textBytes=0;tables=0;root(){return this.check(4,4),this.table(4+this.view.getUint32(4,!0))}check(t,e){if(t<4||t+e>this.bytes.length)throw bt("a frame with an offset past its end")}table(t){if(++this.tables>nc)throw bt(`a frame with more than ${nc} tables`);return new kS(this,t)}text(t,e){if(this.textBytes+=e,this.textBytes>Tu)throw bt(`a frame with more than ${Tu} bytes of text`);return FS.decode(this.bytes.subarray(t,t+e))}}const FS=new TextDecoder,OS={at:0,count:0};class kS{constructor(t,e){if(this.frame=t,this.at=e,this.view=t.view,t.check(e,4),this.vtable=e-this.view.getInt32(e,!0),t.check(this.vtable,4),this.vtableBytes=this.view.getUint16(this.vtable,!0),this.bytes=this.view.getUint16(this.vtable+2,!0),this.vtableBytes<4||this.vtableBytes%2!==0)throw bt("a table with a wrong list of fields");t.check(this.vtable,this.vtableBytes),t.check(e,this.bytes)}view;vtable;vtableBytes;bytes;struct(t,e){const n=4+2*t;if(n+2>this.vtableBytes)return 0;const s=this.view.getUint16(this.vtable+n,!0);if(s===0)return 0;if(s<4||s+e>this.bytes)throw bt("a table with a field outside it");return this.at+s}u8(t){const e=this.struct(t,1);return e===0?0:this.view.getUint8(e)}bool(t){return this.u8(t)!==0}u16(t){const e=this.struct(t,2);return e===0?0:this.view.getUint16(e,!0)}i32(t){const e=this.struct(t,4);return e===0?0:this.view.getInt32(e,!0)}u32(t){return this.i32(t)>>>0}u64(t){const e=this.struct(t,8);return e===0?0n:this.view.getBigUint64(e,!0)}i64(t){return BigInt.asIntN(64,this.u64(t))}target(t){const e=this.struct(t,4);if(e===0)return 0;const n=e+this.view.getUint32(e,!0);return this.frame.check(n,4),n}table(t){const e=this.target(t);return e===0?null:this.frame.table(e)}vector(t,e){const n=this.target(t);if(n===0)return OS;const s=this.view.getUint32(n,!0);return this.frame.check(n+4,s*e),{at:n+4,count:s}}bytesOf(t){const{at:e,count:n}=this.vector(t,1);return new Uint8Array(this.frame.bytes.subarray(e,e+n))}text(t){const{at:e,count:n}=this.vector(t,1);return this.frame.text(e,n)}texts(t){return this.eachOffset(t,e=>{const n=this.view.getUint32(e,!0);return this.frame.check(e+4,n),this.frame.text(e+4,n)})}tables(t,e){return this.eachOffset(t,n=>e(this.frame.table(n)))}eachOffset(t,e){const{at:n,count:s}=this.vector(t,4);if(s>nc)throw bt(`a list of ${s} entries`);const r=[];for(let a=0;a<s;++a){const o=n+4*a+this.view.getUint32(n+4*a,!0);this.frame.check(o,4),r.push(e(o))}return r}get data(){return this.view}}class BS{constructor(t,e){this.ended=t,this.pump=e}waiting=[];running=0;inTurn(t){return new Promise((e,n)=>{const s=this.ended();if(s!==null)throw s;this.waiting.push(()=>{const r=this.ended();if(r!==null){n(r);return}++this.running,t().then(e,n).finally(()=>{--this.running,this.pump()})}),this.pump()})}startNext(){const t=this.waiting.shift();return t?.(),t!==void 0}failAll(){for(const t of this.waiting.splice(0))t()}}const Au=4<<20;function zS(i,t){const e=new DataView(i.buffer,i.byteOffset,i.byteLength);if(i.length<4||i[0]!==1||i[1]!==0)throw bt("no column of chunks of version 1");const n=e.getUint16(2,!0),s=2**(31-t),r=[];let a=4,o=-s;for(let l=0;l<n;++l){if(a+12>i.length)throw bt("a column of chunks that ends within a run");const c=e.getInt32(a,!0),h=e.getUint32(a+4,!0),u=e.getUint32(a+8,!0);if(a+=12,a+u>i.length)throw bt("a column of chunks that ends within a payload");if(c!==o||h===0)throw bt(`a column of chunks with row ${c} after row ${o-1}`);r.push({firstY:c,count:h,payload:i.subarray(a,a+u)}),a+=u,o+=h}if(a!==i.length||o!==s)throw bt("a column of chunks that does not end as it should");return r}function GS(i,t){const e=new DataView(i.buffer,i.byteOffset,i.byteLength);if(i.length<4||i[0]!==1||i[1]!==t||e.getUint16(2,!0)!==0)throw bt(`no square of ${t} x ${t} columns of version 1`);const n=[];let s=4;for(let r=0;r<t*t;++r){if(s+4>i.length)throw bt("a square of columns that ends within one");const a=e.getUint32(s,!0);if(s+=4,s+a>i.length)throw bt("a square of columns that ends within one");n.push(i.subarray(s,s+a)),s+=a}if(s!==i.length)throw bt("a square of columns that goes on after its end");return n}const Kn=32,Ru=4+10*Kn*Kn;function Ca(i,t,e){return{lod:i,x:Math.floor(t/Kn),z:Math.floor(e/Kn)}}function fi({lod:i,x:t,z:e}){return`${i}/${t}/${e}`}class Pi{constructor(t){this.revisions=t}static none=new Pi(new Map);static read(t){const e=new DataView(t.buffer,t.byteOffset,t.byteLength);if(t.length<4||t[0]!==1||t[1]!==0)throw bt("no edited columns of version 1");const n=e.getUint16(2,!0);if(t.length!==4+10*n)throw bt(`${n} edited columns in ${t.length} bytes`);const s=new Map;let r=-1;for(let a=4;a<t.length;a+=10){const o=e.getUint16(a,!0);if(o<=r||o>=Kn*Kn)throw bt(`an edited column ${o} after ${r}`);s.set(o,e.getBigUint64(a+2,!0)),r=o}return new Pi(s)}revision(t,e){return this.revisions.get((e&Kn-1)*Kn+(t&Kn-1))??0n}}function HS(i,t){let e=0n;for(let n=i.z;n<i.z+i.n;++n)for(let s=i.x;s<i.x+i.n;++s){const r=t.revision(s,n);r>e&&(e=r)}return e}function Cu({url:i,revision:t},e){if(t===null)return VS(i,e);if(!/^[0-9]{1,20}$/.test(t))throw bt(`a revision ${t.slice(0,40)}`);return BigInt(t)}function VS(i,t){const e=/@([0-9]{1,20})$/.exec(i);return e===null?t:BigInt(e[1])}class WS{regions=new Map;clear(){this.regions.clear()}follow(t){const e=this.regions;this.regions=new Map,t?.forEachColumn((n,s,r)=>{const a=Ca(n,s,r),o=fi(a);this.regions.has(o)||this.regions.set(o,e.get(o)??{region:a,edited:null})})}has(t){return this.regions.has(fi(t))}take(t,e){const n=this.regions.get(fi(t));return n!==void 0&&(n.edited=e),n!==void 0}of(t,e,n){return this.regions.get(fi(Ca(t,e,n)))?.edited??null}others(t,e=!1){const n=[];for(const[s,{region:r,edited:a}]of this.regions)!t.has(s)&&!(e&&a!==null)&&n.push(r);return n}}class ca extends At{constructor(t,e,n,s,r){super(t,e,n),this.status=s,this.code=r}}const Lu=3e4,XS=16384;async function qS({fetch:i,token:t},e,n,s,r="GET"){const a=AbortSignal.timeout(Lu),o=new AbortController,l=()=>o.abort();s.addEventListener("abort",l),a.addEventListener("abort",l);try{const c=await i(e,{method:r,signal:o.signal,...t===void 0?{}:{headers:{Authorization:`Bearer ${t}`}}});if(!c.ok)throw await $S(c,e);const h=c.headers.get("Talus-Revision");return{body:await qf(c,n,e),url:c.url,revision:h}}catch(c){if(c instanceof At)throw c;if(s.aborted)throw new At("cancelled",`the request for ${e} was given up`);if(a.aborted)throw new At("timed_out",`${e} did not answer within ${Lu/1e3} s`);const h=c.cause?.message??c.message;throw new At("unreachable",`${e} cannot be reached: ${h}${Of(e)}`)}finally{s.removeEventListener("abort",l),a.removeEventListener("abort",l),o.abort()}}async function qf(i,t,e){const n=i.body?.getReader();if(n===void 0)return new Uint8Array(0);let s=new Uint8Array(0),r=0;for(;;){const{done:a,value:o}=await n.read();if(a)return s.subarray(0,r);if(r+o.length>t)throw n.cancel().catch(()=>{}),new At("broken_protocol",`${e} has more than ${t} bytes`);if(r===0)s=o;else{if(r+o.length>s.length){const l=new Uint8Array(Math.min(t,Math.max(2*s.length,r+o.length)));l.set(s.subarray(0,r)),s=l}s.set(o,r)}r+=o.length}}async function $S(i,t){let e="",n=`${t.slice(0,200)} answered ${i.status}`,s=1e3*(Number(i.headers.get("Retry-After"))||0);try{const{error:r}=JSON.parse(new TextDecoder().decode(await qf(i,XS,t)));e=String(r.code),n=`the server says: ${String(r.text)}`,s=Number(r.retry_after_ms)||s}catch{}return new ca(YS(i.status),n,s,i.status,e)}function YS(i){return i===401||i===403?"refused":i===429||i>=500?"overloaded":i===400?"out_of_range":"server_failed"}function Pu(i,t,e){if(!Array.isArray(i)||i.length!==t||!i.every(n=>typeof n=="number"))throw bt(`heights whose ${e} are not ${t} numbers`);return i}function KS(i,t,e,n,s){let r;try{r=JSON.parse(new TextDecoder().decode(i))??{}}catch(c){throw bt(`heights that are no JSON: ${c.message}`)}const a=Int32Array.from(Pu(r.heights,t,"heights"));let o=null;if(e){if(!Array.isArray(r.looks)||r.looks.length!==t)throw bt(`heights without ${t} looks`);o=Uint8Array.from(r.looks,c=>{const h=s.indexOf(c);if(h<0)throw bt("a look that the world does not list");return h})}let l=null;return n.length>0&&(l=new Float32Array(t*n.length),n.forEach((c,h)=>{Pu(r.fields?.[c],t,c).forEach((u,d)=>{l[d*n.length+h]=u})})),{heightsFx:a,looks:o,values:l}}const ZS=700;async function JS(i,{looks:t=!1,fields:e=[]},n,s){const r={heightsFx:new Int32Array(i.length),looks:t?new Uint8Array(i.length):null,values:e.length>0?new Float32Array(i.length*e.length):null},a=[...t?["&looks=1"]:[],...e.length>0?[`&fields=${e.map(encodeURIComponent).join(",")}`]:[]].join("");for(let o=0;o<i.length;){let l="",c=o;for(;c<i.length&&l.length<ZS;++c)l+=`${l===""?"":";"}${i[c].x},${i[c].z}`;const h=KS(await s(`columns=${l}${a}`),c-o,t,e,n());r.heightsFx.set(h.heightsFx,o),h.looks!==null&&r.looks.set(h.looks,o),h.values!==null&&r.values.set(h.values,o*e.length),o=c}return r}function ha({lod:i,x:t,z:e,n}){return n===1?`${i}/${t}/${e}`:`${i}/${t}/${e}/${n}x${n}`}const QS=[[4,6],[2,3]],jS=1.5;function Iu(i,t){for(let e=i.z;e<i.z+i.n;++e)for(let n=i.x;n<i.x+i.n;++n)t(n,e)}function tM(i){const t=i.n/2;return[0,1,2,3].map(e=>({lod:i.lod,x:i.x+t*(e&1),z:i.z+t*(e>>1),n:t}))}function eM(i,t,e){const n=new Map;t.forEachColumn((r,a,o)=>{if(!e(r,a,o))return;const l=nM(i,r,a,o);n.set(ha(l),l)});const s=r=>iM(i,r);return[...n.values()].map(r=>({tile:r,at:s(r)})).sort((r,a)=>r.at-a.at).map(({tile:r})=>r)}function nM(i,t,e,n){const s=32*2**t;for(const[r,a]of QS){const o={lod:t,x:Math.floor(e/r)*r,z:Math.floor(n/r)*r,n:r},l=Math.max(o.x-i.centre.x/s,i.centre.x/s-(o.x+r),0),c=Math.max(o.z-i.centre.z/s,i.centre.z/s-(o.z+r),0);if(Math.max(l,c)>=a)return o}return{lod:t,x:e,z:n,n:1}}function iM(i,{lod:t,x:e,z:n,n:s}){const r=32*2**t,a=(e+s/2)*r-i.centre.x,o=(n+s/2)*r-i.centre.z,l=Math.hypot(a,o),c=i.direction??{x:0,z:0};return c.x*a+c.z*o<0?l*jS:l}const Du=2**17,Nu=2**36;function $f({minY:i,maxY:t}){if(!(i>=-Nu&&t<=Nu&&i<=t&&t-i<=Du))throw bt(`a world with heights from ${i} to ${t}; worlds have at most ${Du} rows`)}function Dn(i){throw bt(`a world whose ${i} is missing or wrong`)}function Ye(i,t){const e=i[t];return typeof e=="number"&&Number.isSafeInteger(e)?e:Dn(t)}function Js(i,t){const e=i[t];return typeof e=="string"?e:Dn(t)}function ic(i,t){const e=i[t];return Array.isArray(e)?e:Dn(t)}function Yf(i,t){const e=i[t];return typeof e=="object"&&e!==null?e:Dn(t)}function Uu(i,t){const e=Js(i,t);return/^[0-9a-f]{32}$/.test(e)?e:Dn(t)}function Fu(i,t){return ic(i,t).map(e=>typeof e=="string"?e:Dn(t))}function sM(i){const t=i??{},e=/^#([0-9a-f]{6})$/.exec(Js(t,"colour")),n=Js(t,"phase");return(e===null||!["gas","liquid","solid"].includes(n))&&Dn("materials"),{id:Ye(t,"id"),name:Js(t,"name"),colour:parseInt(e[1],16),phase:n}}function Ou(i,t){const e=Yf(i,t);return{chunks:Ye(e,"chunks_per_second"),bytes:Ye(e,"bytes_per_second"),requests:Ye(e,"requests_per_second"),burstMs:Ye(e,"burst_ms")}}function rM(i){(typeof i!="object"||i===null)&&Dn("JSON");const t=i,e=Yf(t,"limits"),[n,s,r]=ic(t,"spawn");[n,s,r].every(Number.isSafeInteger)||Dn("spawn"),Ye(t,"chunk_size")!==32&&Dn("chunk_size");const a=Ye(t,"min_y"),o=Ye(t,"max_y");return $f({minY:a,maxY:o}),{protocol:0,fingerprint:Uu(t,"fingerprint"),storeId:Uu(t,"store_id"),codec:Ye(t,"codec"),materials:ic(t,"materials").map(sM),minY:a,maxY:o,spawn:{x:n,y:s,z:r},limits:{frameBytes:0,requestsInFlight:0,heightsPerRequest:Ye(e,"heights_per_request"),viewHorizontalRadius:Ye(e,"view_horizontal_radius"),viewVerticalRadius:Ye(e,"view_vertical_radius"),viewChunks:Ye(e,"view_chunks"),windowBytes:0,idleTimeoutMs:0,sessionRates:Ou(e,"session"),addressRates:Ou(e,"address"),viewHorizon:!0},server:Js(t,"server"),looks:Fu(t,"looks"),fields:Fu(t,"fields")}}const aM=65538,oM=4<<20,ku=6,lM=1<<20,cM=5e3,Bu="0".repeat(32),hM=new Set([401,403,408,425,429]);function Ur(i,t,e){return`${i}/${t}/${e}`}class uM extends Wf{base;getter;abort=new AbortController;tasks=[];running=new Map;asked=new BS(()=>this.isClosed?this.closedError():null,()=>this.pump());columns=new Map;store=Bu;regions=new WS;editsTimer;completeToTell=!1;holdTimer;debts=new WeakMap;owedBytes=0;constructor(t,e){super(t),this.base=e.href.replace(/\/$/,""),this.getter={fetch:t.fetch??globalThis.fetch.bind(globalThis),token:t.token},this.attempt()}get worldUrl(){return`${this.base}/v1/${this.world.fingerprint}`}chunksUrl(t,e){return e===0n?`${this.worldUrl}/${this.world.codec}/${t}`:`${this.worldUrl}/${this.store}/${this.world.codec}/${t}@${e}`}regionUrl(t){return`${this.worldUrl}/${this.store}/edits/${fi(t)}`}async get(t,e,n=this.abort.signal,s="GET"){const r=performance.now();++this.stats.requests;const a=await qS(this.getter,t,e,n,s);return this.stats.latencyMs=performance.now()-r,this.stats.receivedBytes+=a.body.length,a}attempt(){const{signal:t}=this.abort=new AbortController;this.getWorld().then(e=>{t.aborted||this.joined(e)},e=>{t.aborted||this.fail(e)})}async getWorld(){const t=`${this.base}/v1/world`,{body:e}=await this.get(t,oM).catch(n=>{throw this.world!==null||!(n instanceof ca)||hM.has(n.status)||n.status>=500?n:new At("refused",`${t} answered ${n.status}: no Talus server has this URL`)});try{return rM(JSON.parse(new TextDecoder().decode(e)))}catch(n){throw n instanceof At?n:bt(`a world that is no JSON: ${n.message}`)}}worldKnown(t){const{storeId:e}=this.world;(!t||e!==this.store)&&(this.columns.clear(),this.regions.clear()),this.store=e,this.lookForEdits(),this.askForEditsLater(),this.pump()}get hasEdits(){return this.store!==Bu}askForEditsLater(){const t=this.options.editsIntervalMs??cM;!this.hasEdits||!(t>0)||t===1/0||(this.editsTimer??=setTimeout(()=>{this.editsTimer=void 0,this.lookForEdits(),this.askForEditsLater(),this.pump()},t))}lookForEdits(){const t=new Set;for(const e of[...this.tasks,...this.running.keys()])"region"in e&&t.add(fi(e.region));this.tasks.unshift(...this.regions.others(t).map(e=>({region:e})))}editedOf(t,e,n){return this.hasEdits?this.regions.of(t,e,n):Pi.none}isOld({revision:t},e,n,s){return(this.editedOf(e,n,s)?.revision(n,s)??0n)>t}takeRegion(t,e){if(!this.regions.take(t,e))return;const n=[];for(const[r,a]of this.columns){const[o,l,c]=r.split("/").map(Number),h=Ca(o,l,c);o!==t.lod||h.x!==t.x||h.z!==t.z||this.isOld(a,o,l,c)&&n.push({tile:{lod:o,x:l,z:c,n:1}})}const s=new Set([...this.tasks,...this.running.keys()].map(r=>"tile"in r?ha(r.tile):""));this.tasks.unshift(...n.filter(r=>"tile"in r&&!s.has(ha(r.tile))))}fail(t){this.halt(),this.lost(t)}halt(){this.abort.abort(),this.tasks=[];for(const t of this.running.values())t.abort();this.running.clear(),clearTimeout(this.holdTimer),this.holdTimer=void 0,clearTimeout(this.editsTimer),this.editsTimer=void 0,this.completeToTell=!1}stopped(){this.halt(),this.asked.failAll()}viewApplied(){const{view:t,shape:e}=this.tracker;this.completeToTell=t!==null;const n=this.tasks.filter(a=>"region"in a);this.tasks=[],this.regions.follow(this.hasEdits?e:null);for(const[a,{rows:o}]of this.columns){const[l,c,h]=a.split("/").map(Number),u=e?.rows(l,c,h);(u?.first!==o.first||u.last!==o.last)&&this.columns.delete(a)}const s=new Set,r=new Set;for(const[a,o]of this.running){if("region"in a&&(this.regions.has(a.region)?r.add(fi(a.region)):(this.running.delete(a),o.abort())),!("tile"in a))continue;let l=!1;Iu(a.tile,(c,h)=>{e?.hasColumn(a.tile.lod,c,h)&&(l=!0,s.add(Ur(a.tile.lod,c,h)))}),l||(this.running.delete(a),o.abort())}t!==null&&e!==null&&(this.tasks=eM(t,e,(a,o,l)=>{const c=this.columns.get(Ur(a,o,l));return c!==void 0&&!this.isOld(c,a,o,l)?!1:!s.has(Ur(a,o,l))}).map(a=>({tile:a})));for(const a of n)!("region"in a)||!this.regions.has(a.region)||(r.add(fi(a.region)),this.tasks.unshift(a));this.tasks.unshift(...this.regions.others(r,!0).map(a=>({region:a}))),this.pump()}pump(){if(!this.connected)return;const t=Math.max(1,Math.min(ku,this.options.requestsAtOnce??ku)),e=()=>this.asked.running+this.running.size>=t;for(;!e()&&this.asked.startNext(););const n=this.options.windowBytes??lM;for(;!e()&&this.holdTimer===void 0&&this.owedBytes<n;){const s=this.tasks.findIndex(o=>this.mayStart(o));if(s<0)break;const r=this.tasks.splice(s,1)[0],a=new AbortController;this.running.set(r,a),this.run(r,a)}this.completeToTell&&this.tasks.length===0&&this.running.size===0&&(this.completeToTell=!1,this.tellComplete())}mayStart(t){if("region"in t)return!0;const{lod:e,x:n,z:s}="tile"in t?t.tile:t.key;return this.editedOf(e,n,s)!==null}async run(t,e){try{if("region"in t){const{body:n}=await this.get(this.regionUrl(t.region),Ru,e.signal);if(e.signal.aborted)return;this.backoff.reset(),this.takeRegion(t.region,Pi.read(n))}else if("tile"in t){const{tile:n}=t,s=this.editedOf(n.lod,n.x,n.z),r=HS(n,s),a=await this.get(this.chunksUrl(ha(n),r),Au,e.signal);if(e.signal.aborted)return;this.backoff.reset(),this.stats.chunkBytes+=a.body.length,this.takeTile(n,a.body,s,Cu(a,r))}else{const{key:n}=t,{payload:s,revision:r}=await this.getPayload(n,e.signal);if(e.signal.aborted)return;this.backoff.reset(),this.stats.chunkBytes+=s.length,this.give({key:n,revision:r,hash:null,payload:s,material:Zs(s)})}}catch(n){if(e.signal.aborted)return;if(!(n instanceof At))throw n;this.running.delete(t),this.failTask(t,n)}this.running.delete(t),this.pump()}async getPayload(t,e,n=this.editedOf(t.lod,t.x,t.z)?.revision(t.x,t.z)??0n){const s=await this.get(this.chunksUrl(He(t),n),aM,e);return{payload:s.body.slice(),revision:Cu(s,n)}}takeTile(t,e,n,s){const r=t.n===1?[e]:GS(e,t.n);let a=0;Iu(t,(o,l)=>{const c=r[a++],h=this.tracker.shape?.rows(t.lod,o,l);if(h===void 0||h.last<h.first||!this.connected)return;const u=zS(c,t.lod),d=Ur(t.lod,o,l),f=t.n===1?s:n.revision(o,l),m=this.columns.get(d);if(m!==void 0&&m.revision>f)return;const x=f>0n?new Map:null,g={rows:h,revision:f,payloads:x};this.columns.set(d,g),this.isOld(g,t.lod,o,l)&&this.tasks.unshift({tile:{lod:t.lod,x:o,z:l,n:1}});for(const p of u){const S=Math.min(h.last,p.firstY+p.count-1),T=Math.max(h.first,p.firstY);if(T>S)continue;const M=Zs(p.payload),A=x===null?p.payload:p.payload.slice();for(let E=T;E<=S&&this.connected;++E)x?.set(E,A),!dM(m?.payloads?.get(E),p.payload)&&this.give({key:{lod:t.lod,x:o,y:E,z:l},revision:f,hash:null,payload:new Uint8Array(p.payload),material:M})}})}give(t){!this.deliver(t)||!this.options.manualCredit||(this.debts.set(t,t.payload.length),this.owedBytes+=t.payload.length)}taken(t){const e=this.debts.get(t);e!==void 0&&(this.debts.delete(t),this.owedBytes-=e,this.pump())}failTask(t,e){if(e.kind==="overloaded"){this.tasks.unshift(t);const n=this.backoff.next(e.retryAfterMs);if(n===null){this.fail(e);return}this.holdTimer??=setTimeout(()=>{this.holdTimer=void 0,this.pump()},n);return}if(e instanceof ca&&e.status===404){this.fail(new At("disconnected",e.message));return}if(e instanceof ca&&e.code==="too_large"&&"tile"in t){this.tasks.unshift(...this.smaller(t.tile));return}if(e.kind==="out_of_range"||e.kind==="broken_protocol"){"region"in t&&this.takeRegion(t.region,Pi.none),this.emit("error",e);return}this.fail(e)}smaller(t){if(t.n>1)return tM(t).map(o=>({tile:o}));const{lod:e,x:n,z:s}=t,r=this.tracker.shape?.rows(e,n,s),a=[];if(r===void 0)return a;for(let o=r.first;o<=r.last;++o)a.push({key:{lod:e,x:n,y:o,z:s}});return a}async getChunk(t){Bf(t);const{payload:e,revision:n}=await this.asked.inTurn(async()=>{if(!this.hasEdits)return this.getPayload(t,this.abort.signal);const s=Ca(t.lod,t.x,t.z),{body:r}=await this.get(this.regionUrl(s),Ru),a=Pi.read(r).revision(t.x,t.z);return this.getPayload(t,this.abort.signal,a)});return{key:{...t},revision:n,hash:null,payload:e,material:Zs(e)}}async getPlaces(t,e={}){zf(t);const n=async s=>(await this.get(`${this.base}/v1/heights?${s}`,Au)).body;return JS(t,e,()=>this.world.looks,s=>this.asked.inTurn(()=>n(s)))}async edit(){throw new At("refused","edits need a stream: connect by ws:, wss:, tcp: or tls: instead of http:")}editLimits(){return this.edit()}async ping(){if(!this.connected)throw new At("disconnected","ping: the client is not connected");const t=performance.now();return await this.get(`${this.base}/v1/world`,0,this.abort.signal,"HEAD"),this.stats.latencyMs=performance.now()-t}}function dM(i,t){return i!==void 0&&i.length===t.length&&i.every((e,n)=>e===t[n])}const ua=2147483648,sc="0".repeat(32),zu=(i,t)=>i.sequence<t.sequence?-1:1;class fM{editor=sc;seenRevision=0n;state="none";lastSequence=0n;unanswered=1;waiting=[];again=[];inFlight=new Map;lastId=0;add(t){this.waiting.push(t)}get isEmpty(){return this.waiting.length===0&&this.again.length===0&&this.inFlight.size===0}get attachState(){return this.state}attachSent(){this.state="sent"}attachRefused(){this.state="none"}expired(){this.state==="attached"&&(this.state="none")}saw(t){t>this.seenRevision&&(this.seenRevision=t)}attached(t,e,n,s,r){const a=e?[]:this.again;return e||(this.again=[],this.lastSequence=0n),this.state="attached",this.editor=t,n>this.lastSequence&&(this.lastSequence=n),this.unanswered=Math.max(1,r),this.saw(s),a}forgetEditor(){this.connectionEnded();const t=this.again;return this.again=[],this.editor=sc,this.lastSequence=this.seenRevision=0n,t}get hasNext(){return this.state==="attached"&&this.inFlight.size<this.unanswered&&(this.again.length>0||this.waiting.length>0)}sendNext(){let t=this.again.shift();t===void 0&&(t=this.waiting.shift(),t.sequence=++this.lastSequence);do this.lastId=(this.lastId+1)%ua;while(this.inFlight.has(ua+this.lastId));const e=ua+this.lastId;return this.inFlight.set(e,t),{id:e,open:t}}has(t){return this.inFlight.has(t)}take(t){const e=this.inFlight.get(t);return this.inFlight.delete(t),e}putBack(t){const e=this.take(t);e.sentBefore=!0,this.again=[...this.again,e].sort(zu)}sendAsNew(t){const e=this.take(t);e.sentBefore=!1;const n=this.waiting.findIndex(({sequence:s})=>s===0n||s>e.sequence);this.waiting.splice(n<0?this.waiting.length:n,0,e)}connectionEnded(){this.state="none";for(const t of this.inFlight.values())t.sentBefore=!0;this.again=[...this.again,...this.inFlight.values()].sort(zu),this.inFlight.clear()}takeAll(){this.connectionEnded();const t={sent:this.again,unsent:this.waiting};return this.again=[],this.waiting=[],t}}const Po=2,Pn=4,Zn=4,pM=4,hi=new Int32Array(2),Gu=new Float32Array(hi.buffer),Hu=new Float64Array(hi.buffer),Fr=new Uint16Array(new Uint8Array([1,0]).buffer)[0]===1;var rc;(function(i){i[i.UTF8_BYTES=1]="UTF8_BYTES",i[i.UTF16_STRING=2]="UTF16_STRING"})(rc||(rc={}));class La{constructor(t){this.bytes_=t,this.position_=0,this.text_decoder_=new TextDecoder}static allocate(t){return new La(new Uint8Array(t))}clear(){this.position_=0}bytes(){return this.bytes_}position(){return this.position_}setPosition(t){this.position_=t}capacity(){return this.bytes_.length}readInt8(t){return this.readUint8(t)<<24>>24}readUint8(t){return this.bytes_[t]}readInt16(t){return this.readUint16(t)<<16>>16}readUint16(t){return this.bytes_[t]|this.bytes_[t+1]<<8}readInt32(t){return this.bytes_[t]|this.bytes_[t+1]<<8|this.bytes_[t+2]<<16|this.bytes_[t+3]<<24}readUint32(t){return this.readInt32(t)>>>0}readInt64(t){return BigInt.asIntN(64,BigInt(this.readUint32(t))+(BigInt(this.readUint32(t+4))<<BigInt(32)))}readUint64(t){return BigInt.asUintN(64,BigInt(this.readUint32(t))+(BigInt(this.readUint32(t+4))<<BigInt(32)))}readFloat32(t){return hi[0]=this.readInt32(t),Gu[0]}readFloat64(t){return hi[Fr?0:1]=this.readInt32(t),hi[Fr?1:0]=this.readInt32(t+4),Hu[0]}writeInt8(t,e){this.bytes_[t]=e}writeUint8(t,e){this.bytes_[t]=e}writeInt16(t,e){this.bytes_[t]=e,this.bytes_[t+1]=e>>8}writeUint16(t,e){this.bytes_[t]=e,this.bytes_[t+1]=e>>8}writeInt32(t,e){this.bytes_[t]=e,this.bytes_[t+1]=e>>8,this.bytes_[t+2]=e>>16,this.bytes_[t+3]=e>>24}writeUint32(t,e){this.bytes_[t]=e,this.bytes_[t+1]=e>>8,this.bytes_[t+2]=e>>16,this.bytes_[t+3]=e>>24}writeInt64(t,e){this.writeInt32(t,Number(BigInt.asIntN(32,e))),this.writeInt32(t+4,Number(BigInt.asIntN(32,e>>BigInt(32))))}writeUint64(t,e){this.writeUint32(t,Number(BigInt.asUintN(32,e))),this.writeUint32(t+4,Number(BigInt.asUintN(32,e>>BigInt(32))))}writeFloat32(t,e){Gu[0]=e,this.writeInt32(t,hi[0])}writeFloat64(t,e){Hu[0]=e,this.writeInt32(t,hi[Fr?0:1]),this.writeInt32(t+4,hi[Fr?1:0])}getBufferIdentifier(){if(this.bytes_.length<this.position_+Pn+Zn)throw new Error("FlatBuffers: ByteBuffer is too short to contain an identifier.");let t="";for(let e=0;e<Zn;e++)t+=String.fromCharCode(this.readInt8(this.position_+Pn+e));return t}__offset(t,e){const n=t-this.readInt32(t);return e<this.readInt16(n)?this.readInt16(n+e):0}__union(t,e){return t.bb_pos=e+this.readInt32(e),t.bb=this,t}__string(t,e){t+=this.readInt32(t);const n=this.readInt32(t);t+=Pn;const s=this.bytes_.subarray(t,t+n);return e===rc.UTF8_BYTES?s:this.text_decoder_.decode(s)}__union_with_string(t,e){return typeof t=="string"?this.__string(e):this.__union(t,e)}__indirect(t){return t+this.readInt32(t)}__vector(t){return t+this.readInt32(t)+Pn}__vector_len(t){return this.readInt32(t+this.readInt32(t))}__has_identifier(t){if(t.length!=Zn)throw new Error("FlatBuffers: file identifier must be length "+Zn);for(let e=0;e<Zn;e++)if(t.charCodeAt(e)!=this.readInt8(this.position()+Pn+e))return!1;return!0}createScalarList(t,e){const n=[];for(let s=0;s<e;++s){const r=t(s);r!==null&&n.push(r)}return n}createObjList(t,e){const n=[];for(let s=0;s<e;++s){const r=t(s);r!==null&&n.push(r.unpack())}return n}}let mM=class Kf{constructor(t){this.minalign=1,this.vtable=null,this.vtable_in_use=0,this.isNested=!1,this.object_start=0,this.vtables=[],this.vector_num_elems=0,this.force_defaults=!1,this.string_maps=null,this.text_encoder=new TextEncoder;let e;t?e=t:e=1024,this.bb=La.allocate(e),this.space=e}clear(){this.bb.clear(),this.space=this.bb.capacity(),this.minalign=1,this.vtable=null,this.vtable_in_use=0,this.isNested=!1,this.object_start=0,this.vtables=[],this.vector_num_elems=0,this.force_defaults=!1,this.string_maps=null}forceDefaults(t){this.force_defaults=t}dataBuffer(){return this.bb}asUint8Array(){return this.bb.bytes().subarray(this.bb.position(),this.bb.position()+this.offset())}prep(t,e){t>this.minalign&&(this.minalign=t);const n=~(this.bb.capacity()-this.space+e)+1&t-1;for(;this.space<n+t+e;){const s=this.bb.capacity();this.bb=Kf.growByteBuffer(this.bb),this.space+=this.bb.capacity()-s}this.pad(n)}pad(t){for(let e=0;e<t;e++)this.bb.writeInt8(--this.space,0)}writeInt8(t){this.bb.writeInt8(this.space-=1,t)}writeInt16(t){this.bb.writeInt16(this.space-=2,t)}writeInt32(t){this.bb.writeInt32(this.space-=4,t)}writeInt64(t){this.bb.writeInt64(this.space-=8,t)}writeFloat32(t){this.bb.writeFloat32(this.space-=4,t)}writeFloat64(t){this.bb.writeFloat64(this.space-=8,t)}addInt8(t){this.prep(1,0),this.writeInt8(t)}addInt16(t){this.prep(2,0),this.writeInt16(t)}addInt32(t){this.prep(4,0),this.writeInt32(t)}addInt64(t){this.prep(8,0),this.writeInt64(t)}addFloat32(t){this.prep(4,0),this.writeFloat32(t)}addFloat64(t){this.prep(8,0),this.writeFloat64(t)}addFieldInt8(t,e,n){(this.force_defaults||e!=n)&&(this.addInt8(e),this.slot(t))}addFieldInt16(t,e,n){(this.force_defaults||e!=n)&&(this.addInt16(e),this.slot(t))}addFieldInt32(t,e,n){(this.force_defaults||e!=n)&&(this.addInt32(e),this.slot(t))}addFieldInt64(t,e,n){(this.force_defaults||e!==n)&&(this.addInt64(e),this.slot(t))}addFieldFloat32(t,e,n){(this.force_defaults||e!=n)&&(this.addFloat32(e),this.slot(t))}addFieldFloat64(t,e,n){(this.force_defaults||e!=n)&&(this.addFloat64(e),this.slot(t))}addFieldOffset(t,e,n){(this.force_defaults||e!=n)&&(this.addOffset(e),this.slot(t))}addFieldStruct(t,e,n){e!=n&&(this.nested(e),this.slot(t))}nested(t){if(t!=this.offset())throw new TypeError("FlatBuffers: struct must be serialized inline.")}notNested(){if(this.isNested)throw new TypeError("FlatBuffers: object serialization must not be nested.")}slot(t){this.vtable!==null&&(this.vtable[t]=this.offset())}offset(){return this.bb.capacity()-this.space}static growByteBuffer(t){const e=t.capacity();if(e&3221225472)throw new Error("FlatBuffers: cannot grow buffer beyond 2 gigabytes.");const n=e<<1,s=La.allocate(n);return s.setPosition(n-e),s.bytes().set(t.bytes(),n-e),s}addOffset(t){this.prep(Pn,0),this.writeInt32(this.offset()-t+Pn)}startObject(t){this.notNested(),this.vtable==null&&(this.vtable=[]),this.vtable_in_use=t;for(let e=0;e<t;e++)this.vtable[e]=0;this.isNested=!0,this.object_start=this.offset()}endObject(){if(this.vtable==null||!this.isNested)throw new Error("FlatBuffers: endObject called without startObject");this.addInt32(0);const t=this.offset();let e=this.vtable_in_use-1;for(;e>=0&&this.vtable[e]==0;e--);const n=e+1;for(;e>=0;e--)this.addInt16(this.vtable[e]!=0?t-this.vtable[e]:0);const s=2;this.addInt16(t-this.object_start);const r=(n+s)*Po;this.addInt16(r);let a=0;const o=this.space;t:for(e=0;e<this.vtables.length;e++){const l=this.bb.capacity()-this.vtables[e];if(r==this.bb.readInt16(l)){for(let c=Po;c<r;c+=Po)if(this.bb.readInt16(o+c)!=this.bb.readInt16(l+c))continue t;a=this.vtables[e];break}}return a?(this.space=this.bb.capacity()-t,this.bb.writeInt32(this.space,a-t)):(this.vtables.push(this.offset()),this.bb.writeInt32(this.bb.capacity()-t,this.offset()-t)),this.isNested=!1,t}finish(t,e,n){const s=n?pM:0;if(e){const r=e;if(this.prep(this.minalign,Pn+Zn+s),r.length!=Zn)throw new TypeError("FlatBuffers: file identifier must be length "+Zn);for(let a=Zn-1;a>=0;a--)this.writeInt8(r.charCodeAt(a))}this.prep(this.minalign,Pn+s),this.addOffset(t),s&&this.addInt32(this.bb.capacity()-this.space),this.bb.setPosition(this.space)}finishSizePrefixed(t,e){this.finish(t,e,!0)}requiredField(t,e){const n=this.bb.capacity()-t,s=n-this.bb.readInt32(n);if(!(e<this.bb.readInt16(s)&&this.bb.readInt16(s+e)!=0))throw new TypeError("FlatBuffers: field "+e+" must be set")}startVector(t,e,n){this.notNested(),this.vector_num_elems=e,this.prep(Pn,t*e),this.prep(n,t*e)}endVector(){return this.writeInt32(this.vector_num_elems),this.offset()}createSharedString(t){if(!t)return 0;if(this.string_maps||(this.string_maps=new Map),this.string_maps.has(t))return this.string_maps.get(t);const e=this.createString(t);return this.string_maps.set(t,e),e}createString(t){if(t==null)return 0;let e;return t instanceof Uint8Array?e=t:e=this.text_encoder.encode(t),this.addInt8(0),this.startVector(1,e.length,1),this.bb.setPosition(this.space-=e.length),this.bb.bytes().set(e,this.space),this.endVector()}createByteVector(t){return t==null?0:(this.startVector(1,t.length,1),this.bb.setPosition(this.space-=t.length),this.bb.bytes().set(t,this.space),this.endVector())}createObjectOffset(t){return t===null?0:typeof t=="string"?this.createString(t):t.pack(this)}createObjectOffsetList(t){const e=[];for(let n=0;n<t.length;++n){const s=t[n];if(s!==null)e.push(this.createObjectOffset(s));else throw new TypeError("FlatBuffers: Argument for createObjectOffsetList cannot contain null.")}return e}createStructOffsetList(t,e){return e(this,t.length),this.createObjectOffsetList(t.slice().reverse()),this.endVector()}};const Zf=40,Jf=32,Qf=16,jf=128;function xi(i,t){const e=new mM(256),n=t(e);return e.startObject(2),e.addFieldOffset(1,n,0),e.addFieldInt8(0,i,0),e.finishSizePrefixed(e.endObject()),e.asUint8Array()}function zi(i,t,e,n,s){i.startVector(e,t.length,n);for(let r=t.length-1;r>=0;--r)i.prep(n,e),s(t[r]);return i.endVector()}function Gc(i,t){i.writeInt64(BigInt(`0x${t.slice(0,16)}`)),i.writeInt64(BigInt(`0x${t.slice(16)}`))}function tp(i,t){i.pad(3),i.writeInt8(t.lod),i.writeInt32(t.z),i.writeInt32(t.y),i.writeInt32(t.x)}function gM(i){return xi(1,t=>{t.startVector(1,i.codecs.length,1);for(let r=i.codecs.length-1;r>=0;--r)t.addInt8(i.codecs[r]);const e=t.endVector(),n=t.createString(i.token),s=t.createString(i.client);return t.startObject(6),t.addFieldInt64(5,BigInt(i.windowBytes),0n),t.addFieldOffset(4,s,0),t.addFieldOffset(3,n,0),t.addFieldOffset(2,e,0),t.addFieldInt16(1,i.protocolMax,0),t.addFieldInt16(0,i.protocolMin,0),t.endObject()})}function Vu(i,t,e){return xi(2,n=>{const s=zi(n,e,Jf,8,a=>{Gc(n,a.hash),tp(n,a.key)}),r=zi(n,i.rings??[],4,2,a=>{n.writeInt16(a.radius),n.pad(1),n.writeInt8(a.lod)});return n.startObject(8),n.prep(8,24),n.writeInt64(BigInt(i.centre.z)),n.writeInt64(BigInt(i.centre.y)),n.writeInt64(BigInt(i.centre.x)),n.addFieldStruct(0,n.offset(),0),i.direction!==void 0&&(n.prep(4,12),n.writeFloat32(i.direction.z),n.writeFloat32(i.direction.y),n.writeFloat32(i.direction.x),n.addFieldStruct(1,n.offset(),0)),n.addFieldInt16(2,i.horizontalRadius,0),n.addFieldInt16(3,i.verticalRadius,0),n.addFieldOffset(4,r,0),n.addFieldOffset(5,s,0),n.addFieldInt32(6,t,0),n.addFieldInt8(7,i.horizon?1:0,0),n.endObject()})}function vM(i){return xi(3,t=>{const e=zi(t,i,Zf,8,n=>{Gc(t,n.known??"0".repeat(32)),t.pad(3),t.writeInt8(n.known===null?0:1),tp(t,n.key),t.writeInt32(n.id)});return t.startObject(1),t.addFieldOffset(0,e,0),t.endObject()})}function _M(i,t,e,n){return xi(5,s=>{const r=zi(s,t,Qf,8,o=>{s.writeInt64(BigInt(o.z)),s.writeInt64(BigInt(o.x))}),a=zi(s,n,1,1,o=>s.writeInt8(o));return s.startObject(4),s.addFieldOffset(3,a,0),s.addFieldOffset(1,r,0),s.addFieldInt32(0,i,0),s.addFieldInt8(2,e?1:0,0),s.endObject()})}function xM(i){return xi(6,t=>(t.startObject(1),t.addFieldInt64(0,BigInt(i),0n),t.endObject()))}function wM(i){return xi(8,t=>(t.startObject(1),t.addFieldInt64(0,BigInt(i),0n),t.endObject()))}const Hc=24;function Pa(i,{x:t,y:e,z:n}){i.writeInt64(BigInt(n)),i.writeInt64(BigInt(e)),i.writeInt64(BigInt(t))}function Wu(i,t){return t.length===0?0:zi(i,t,Hc+8,8,({voxel:e,material:n})=>{i.pad(6),i.writeInt16(n),Pa(i,e)})}function SM(i,t){return t.length===0?0:zi(i,t,2*Hc+8,8,e=>{i.pad(3),i.writeInt8(e.flags),i.writeInt16(e.only),i.writeInt16(e.material),Pa(i,e.last),Pa(i,e.first)})}function MM(i,t){if(t===null)return 0;const e=i.createByteVector(t.payload);return i.startObject(3),i.prep(8,Hc),Pa(i,t.origin),i.addFieldStruct(0,i.offset(),0),i.addFieldOffset(1,e,0),i.addFieldInt8(2,t.withAir?1:0,0),i.endObject()}function yM(i,t,e){return xi(7,n=>{const s=Wu(n,e.writes),r=Wu(n,e.guards),a=SM(n,e.fills),o=MM(n,e.paste),l=e.subject===""?0:n.createString(e.subject);return n.startObject(7),n.addFieldInt64(2,t,0n),n.addFieldInt32(0,i,0),n.addFieldOffset(1,s,0),n.addFieldOffset(3,r,0),n.addFieldOffset(4,a,0),n.addFieldOffset(5,o,0),n.addFieldOffset(6,l,0),n.endObject()})}function EM(i,t){return xi(20,e=>(e.startObject(2),e.prep(8,16),Gc(e,i),e.addFieldStruct(0,e.offset(),0),e.addFieldInt64(1,t,0n),e.endObject()))}const bM={empty:"has no bytes; it needs at least a version and an encoding",unknown_version:"begins with a byte that is no version known here, 3 or 4",unknown_encoding:"has a second byte that names no encoding of its version",truncated:"ends before the chunk does; it must be passed whole",too_long:"goes on after the chunk's end; it must be passed without other bytes",bad_materials:"has a list of materials that is empty, too long or out of order",bad_number:"holds a number that is past its range or not in its shortest form",bad_ending:"does not end as its chunk does; it was changed on its way",bad_hash:"decodes to voxels that do not have the hash it came with"};class Yt extends At{constructor(t){super("bad_chunk",`the chunk payload ${bM[t]}`),this.fault=t}}const oe=16,Io=256,TM=2*oe,Vc=65538,AM=4096;class RM{bytes=new Uint8Array(Vc+AM);states=new Int32Array(oe);next=0;end=0;begin(t){this.bytes.set(t),this.next=2,this.end=t.length}left(){return this.end-this.next}number(){let t=0;for(let e=0;e<=14;e+=7){if(this.next>=this.end)throw new Yt("truncated");const n=this.bytes[this.next++];if(t|=(n&127)<<e,!(n>=128)){if(n===0&&e>0||t>65535)break;return t}}throw new Yt("bad_number")}materials(t){const e=this.number();if(e===0||e>t)throw new Yt("bad_materials");const n=[];for(let s=0;s<e;++s)n.push(this.number());return n}takeStates(){if(this.left()<TM)throw new Yt("truncated");for(let t=0;t<oe;++t){const e=this.bytes[this.next]|this.bytes[this.next+1]<<8;if(e<Io)throw new Yt("bad_ending");this.states[t]=e,this.next+=2}}read(t,e){let n=this.states[e];const s=t[n&255];return n=(s>>>16)*(n>>8)+(n&255)-(s>>8&255),n<Io&&(n=n<<8|this.bytes[this.next++]),this.states[e]=n,s&255}checkRead(){if(this.next>this.end)throw new Yt("truncated")}checkAllRead(){if(this.next!==this.end)throw new Yt("too_long")}checkFinalStates(){for(let t=0;t<oe;++t)if(this.states[t]!==Io)throw new Yt("bad_ending")}}function $a(i,t){let e=0;for(let n=0;n<t.length;++n){const s=t[n];if(e+s>256)throw new Yt("bad_number");i.fill(n|e<<8|s<<16,e,e+s),e+=s}if(e!==256)throw new Yt("bad_number")}const CM=256;class LM{steps=[];symbol(t,e,n){this.steps.push(t|e<<8|n<<16)}byte(t){this.steps.push(-1-t)}finish(){const t=new Array(oe).fill(CM),e=[];for(let n=this.steps.length-1;n>=0;--n){const s=this.steps[n];if(s<0){e.push(-1-s);continue}const r=s&255,a=s>>8&255,o=s>>>16;let l=t[r];l>=o*256&&(e.push(l&255),l>>>=8),t[r]=Math.floor(l/o)*256+l%o+a}for(let n=oe-1;n>=0;--n)e.push(t[n]>>>8,t[n]&255);return e.reverse()}}function Xu(i,t){const e=i.reduce((r,a)=>r+a,0),n=i.map(r=>r===0?0:Math.min(t,Math.max(1,Math.round(r*256/e))));let s=256-n.reduce((r,a)=>r+a,0);for(;s!==0;s-=Math.sign(s)){let r=-1;for(let a=0;a<n.length;++a)s>0&&n[a]>=t||(r<0||n[a]>n[r])&&(r=a);n[r]+=Math.sign(s)}return n}const Ci=32768,PM=256,IM=16;function Wc({uniform:i,voxels:t}){if(t===null)return nr(i);if(t.length!==Ci)throw new At("out_of_range",`encodeChunk: a chunk has ${Ci} voxels, not ${t.length}`);const e=[],n=[];for(let r=0;r<Ci;++r)r>0&&t[r]===t[r-1]?++n[n.length-1]:(e.push(t[r]),n.push(1));if(e.length===1)return nr(e[0]);const s=e.length<Ci?NM(e,n):null;return s!==null&&s.length<2*Ci+2?s:DM(t)}function DM(i){const t=new Uint8Array(2*Ci+2);t.set([4,2]);const e=new DataView(t.buffer);for(let n=0;n<Ci;++n)e.setUint16(2+2*n,i[n],!0);return t}function Do(i,t){for(;t>=128;t>>=7)i.push(t&127|128);i.push(t)}function qu(i){let t=0;return i.map(e=>(t+=e)-e)}function NM(i,t){const e=[...new Set(i)].sort((m,x)=>m-x);if(e.length>PM)return null;const n=new Map(e.map((m,x)=>[m,x])),s=i.map(m=>n.get(m)),r=new Array(e.length).fill(0);for(const m of s)++r[m];const a=m=>32-Math.clz32(m),o=new Array(IM).fill(0);for(const m of t)++o[a(m-1)];const l=Xu(r,256),c=Xu(o,255),h=[4,3];Do(h,e.length);for(const m of e)Do(h,m);for(const m of l)h.push(m-1);Do(h,i.length),h.push(...c);const u=new LM,d=qu(l),f=qu(c);for(let m=0;m<s.length;m+=oe){const x=Math.min(oe,s.length-m);for(let S=0;S<x;++S){const T=a(t[m+S]-1);u.symbol(S,f[T],c[T])}let g=0,p=0;for(let S=0;S<x;++S){const T=t[m+S]-1,M=a(T)-1;if(!(M<1))for(p|=(T&(1<<M)-1)<<g,g+=M;g>=8;g-=8,p>>>=8)u.byte(p&255)}g>0&&u.byte(p&255);for(let S=0;S<x;++S)u.symbol(S,d[s[m+S]],l[s[m+S]])}return Uint8Array.from([...h,...u.finish()])}function Xc(i){return new At("out_of_range",`edit: ${i}`)}function Ia(i,t){const{x:e,y:n,z:s}=i;if([e,n,s].every(Number.isSafeInteger))return{x:e,y:n,z:s};throw Xc(`${t} (${e}, ${n}, ${s}) must be of whole numbers`)}function ac(i,t){if(Number.isInteger(i)&&i>=0&&i<=65535)return i;throw Xc(`material ${i} of ${t}; materials are 0 to 65535`)}function $u(i=[],t){return i.map(e=>({voxel:Ia(e.voxel,t),material:ac(e.material,t)}))}function UM({first:i,last:t,material:e,only:n}){const s={first:Ia(i,"fill.first"),last:Ia(t,"fill.last")};if(i.x>t.x||i.y>t.y||i.z>t.z)throw Xc("fill.first must be the lowest corner, fill.last the highest");return{...s,material:e==="generated"?0:ac(e,"a fill"),only:n===void 0?0:ac(n,"fill.only"),flags:(n===void 0?1:0)|(e==="generated"?2:0)}}function FM(i){const{paste:t}=i;return{guards:$u(i.guards,"a guard"),writes:$u(i.writes,"a write"),fills:(i.fills??[]).map(UM),paste:t===void 0?null:{origin:Ia(t.origin,"paste.origin"),payload:Wc(t.voxels),withAir:t.withAir??!1},subject:i.subject??""}}const OM="0".repeat(32);function No(i){return i.storeId===OM?new At("refused","this server stores no edits"):null}const Or=()=>new At("outcome_unknown","the server knows nothing of this edit any more: it may have happened, or not");function kr(i,t){for(const{reject:e}of i)e(t)}class kM{constructor(t){this.wake=t}open=new fM;askers=[];limits=null;storeId=null;edit(t,e){return new Promise((n,s)=>{const r=e===null?null:No(e);if(r!==null)throw r;this.open.add({edit:qa("edit",()=>FM(t)),sequence:0n,sentBefore:!1,resolve:n,reject:s}),this.wake()})}askLimits(t){return new Promise((e,n)=>{const s=t===null?null:No(t);if(s!==null)throw s;if(this.limits!==null)return e(this.limits);this.askers.push({resolve:e,reject:n}),this.wake()})}saw(t){this.open.saw(t)}joined(t,e){const n=this.storeId===null||this.storeId===t.storeId;this.storeId=t.storeId;const s=No(t);(!n||s!==null)&&kr(this.open.forgetEditor(),Or()),s!==null?this.failAll(s):!e&&!n&&this.failAll(new At("not_applied","the server has another world now"))}connectionEnded(){this.open.connectionEnded(),this.limits=null}failAll(t){const{sent:e,unsent:n}=this.open.takeAll();kr(e,t.kind==="closed"?t:Or()),kr(n,t);for(const{reject:s}of this.askers.splice(0))s(t)}get hasNext(){return this.mustAttach||this.open.hasNext}get mustAttach(){return this.open.attachState==="none"&&(!this.open.isEmpty||this.askers.length>0)}next(t){if(this.mustAttach)return this.open.attachSent(),EM(this.open.editor,this.open.seenRevision);const{id:e,open:n}=this.open.sendNext(),s=yM(e,n.sequence,n.edit);if(s.length<=t)return s;const r=`an edit of ${s.length} bytes is more than this server takes in a frame (${t}); divide it`;return this.open.take(e).reject(new At("out_of_range",r)),null}handleAttached(t){if(this.open.attachState!=="sent"||t.editor===sc)throw bt("an Attached that no Attach asked for, or without an editor");const{editor:e,known:n,lastSequence:s,revision:r,limits:a}=t;kr(this.open.attached(e,n,s,r,a.unanswered),Or()),this.limits=a;for(const{resolve:o}of this.askers.splice(0))o(a)}handleResult({id:t,revision:e,changed:n}){if(!this.open.has(t))throw bt(`an EditResult for request ${t}, which is no edit in flight`);this.open.saw(e),this.open.take(t).resolve({revision:e,changed:n})}editRefused(t,e,n){const s=t.requestId;if(!this.open.has(s))throw bt(`an Error about request ${s}, which is no edit in flight`);if(n)this.open.putBack(s);else if(t.code==="expired")this.open.putBack(s),this.open.expired();else if(t.code==="not_applied")this.open.sendAsNew(s);else{const r=this.open.take(s);r.reject(r.sentBefore&&t.code!=="conflict"?Or():e)}}attachRefused(t,e){this.open.attachState==="sent"&&(this.open.attachRefused(),e||this.failAll(t))}}function ep(i){const t=Array.isArray(i)?i:[i];if(t.length===0)throw new At("unreachable","url: there is none");for(const e of t)if(typeof e!="string")throw new At("unreachable",`url: a string or a list of strings is needed, not ${e===null?"null":typeof e}`);return t}function qc(i){return i.replace(/[?#].*$/s,"").replace(/^([^/]*:?\/\/)?.*@/s,"$1")}function np(i){const t=n=>new At("unreachable",`url ${qc(i)}: ${n}`);let e;try{const n=globalThis.location;e=new URL(i,n?.host?n.origin+n.pathname:void 0)}catch{}if(e===void 0||e.hostname==="")throw t("it is not one of a server, as ws://127.0.0.1:4781 is");if(e.username!==""||e.password!=="")throw t("user and password in it are never sent; give the token as the option token");return e.search=e.hash="",e}const cs=4,Yu=12,Ku=262144;class Zu{held=new Uint8Array(0);count=0;push(t,e){let n=t;for(;n.length>0;){if(this.count===0){const a=Uo(n);if(a!==null&&a<=n.length){e(n.subarray(0,a)),n=n.subarray(a);continue}}const s=this.count<cs?cs:Uo(this.held),r=Math.min(s-this.count,n.length);if(this.keep(n.subarray(0,r)),n=n.subarray(r),this.count>=cs&&this.count===Uo(this.held)){const a=this.held.subarray(0,this.count);this.count=0,e(a)}}}keep(t){if(this.count+t.length>this.held.length){const e=new Uint8Array(Math.max(1024,2*this.held.length,this.count+t.length));e.set(this.held.subarray(0,this.count)),this.held=e}this.held.set(t,this.count),this.count+=t.length}}const BM=1347703880+cs;function Uo(i){if(i.length<cs)return null;const t=(i[0]|i[1]<<8|i[2]<<16)+i[3]*16777216+cs;if(t===BM)throw bt("HTTP, not frames: connect by http:// or ws:// there");if(t<Yu||t>Ku)throw bt(`a frame of ${t} bytes; frames have ${Yu} to ${Ku}`);return t}const zM=["none","version","malformed","unexpected","too_large","too_many_requests","out_of_range","cancelled","unsupported","unauthorized","overloaded","timeout","duplicate_id","internal","forbidden","conflict","expired","not_applied"],GM=["unspecified","connection","request","repeated_request","view","view_chunk","ping","attach"],HM=["gas","liquid","solid"],VM={9:KM,10:i=>({kind:"chunk",id:i.u32(0),key:Br(i,1),revision:i.u64(2),hash:Qs(i,3),codec:i.u8(4),payload:i.bytesOf(5)}),11:i=>({kind:"unchanged",id:i.u32(0),key:Br(i,1),revision:i.u64(2),hash:Qs(i,3)}),12:ZM,13:JM,14:i=>({kind:"error",code:zM[i.u16(0)]??"unknown",text:i.text(1),requestId:i.u32(2),retryAfterMs:i.u32(3),about:GM[i.u8(4)]??"unspecified",repeatedId:i.u32(5),viewNumber:i.u32(6),chunk:i.struct(7,16)===0?null:Br(i,7)}),15:i=>({kind:"edit_result",id:i.u32(0),revision:i.u64(1),changed:i.u32(2)}),16:i=>({kind:"edit_broadcast",key:Br(i,0),revision:i.u64(1),previousRevision:i.u64(2),runs:i.bytesOf(4)}),17:i=>({kind:"pong",nonce:i.u64(0)}),18:i=>({kind:"go_away",reason:i.text(0),retryAfterMs:i.u32(1)}),19:i=>({kind:"view_complete",number:i.u32(0)}),21:i=>({kind:"attached",editor:Qs(i,0),epoch:i.u64(1),lastSequence:i.u64(2),known:i.bool(3),revision:i.u64(4),limits:$M(i.table(5))})};function WM(i){const t=new US(i).root(),e=t.u8(0),n=VM[e],s=t.table(1);if(n===void 0||s===null)throw bt(`a message of kind ${e}, which no server sends`);return n(s)}function Br(i,t){const e=i.struct(t,16);if(e===0)throw bt("a chunk without a key");return{lod:i.data.getUint8(e+12),x:i.data.getInt32(e,!0),y:i.data.getInt32(e+4,!0),z:i.data.getInt32(e+8,!0)}}function Ju(i,t){const e=n=>n.toString(16).padStart(8,"0");return e(i.getUint32(t+4,!0))+e(i.getUint32(t,!0))}function Qs(i,t){const e=i.struct(t,16);return e===0?"0".repeat(32):Ju(i.data,e+8)+Ju(i.data,e)}function oc(i,t){const e=Number(i);if(!Number.isSafeInteger(e))throw bt(`${t} ${i}, which is beyond any world`);return e}function XM(i,t,e){const n=i.struct(t,24);if(n===0)return{x:0,y:0,z:0};const s=r=>oc(i.data.getBigInt64(n+8*r,!0),e);return{x:s(0),y:s(1),z:s(2)}}function Qu(i){return i===null?null:{chunks:Number(i.u64(0)),bytes:Number(i.u64(1)),requests:Number(i.u64(2)),burstMs:i.u32(3)}}function qM(i){if(i===null)throw bt("a Welcome without limits");return{frameBytes:i.u32(0),requestsInFlight:i.u32(1),heightsPerRequest:i.u32(2),viewHorizontalRadius:i.u16(3),viewVerticalRadius:i.u16(4),viewChunks:i.u32(5),windowBytes:Number(i.u64(6)),idleTimeoutMs:i.u32(7),sessionRates:Qu(i.table(8)),addressRates:Qu(i.table(9)),viewHorizon:i.bool(10)}}function $M(i){if(i===null)throw bt("an Attached without limits");return{voxels:i.u32(0),chunks:i.u32(1),unanswered:i.u32(2),voxelsPerSecond:Number(i.u64(3))}}function YM(i){return{id:i.u16(0),name:i.text(1),colour:i.u32(2),phase:HM[i.u8(3)]??"solid"}}function KM(i){const t=i.u16(4);if(t!==32)throw bt(`a Welcome with chunks of ${t} voxels; this client knows 32`);const e={protocol:i.u16(0),fingerprint:Qs(i,2),storeId:Qs(i,3),codec:i.u8(1),materials:i.tables(5,YM),minY:oc(i.i64(6),"min_y"),maxY:oc(i.i64(7),"max_y"),spawn:XM(i,8,"a spawn at"),limits:qM(i.table(9)),server:i.text(10),looks:i.texts(11),fields:i.texts(12)};return $f(e),{kind:"welcome",world:e}}function ZM(i){const{at:t,count:e}=i.vector(4,12),n=[];for(let s=0;s<e;++s){const r=t+12*s;n.push({firstY:i.data.getInt32(r,!0),lastY:i.data.getInt32(r+4,!0),material:i.data.getUint16(r+8,!0)})}return{kind:"uniform_column",x:i.i32(0),z:i.i32(1),lod:i.u8(2),revision:i.u64(3),runs:n}}function JM(i){const t=i.vector(1,4),e=i.vector(3,4);return{kind:"heights",id:i.u32(0),heightsFx:Int32Array.from({length:t.count},(n,s)=>i.data.getInt32(t.at+4*s,!0)),looks:i.bytesOf(2),values:Float32Array.from({length:e.count},(n,s)=>i.data.getFloat32(e.at+4*s,!0))}}class QM{debts=new WeakMap;connection=0;takenBytes=0;creditedBytes=0;begin(){++this.connection,this.takenBytes=this.creditedBytes=0}owe(t,e){this.debts.set(t,{connection:this.connection,bytes:e})}taken(t,e){const n=this.debts.get(t);return n===void 0||(this.debts.delete(t),n.connection!==this.connection)||(this.takenBytes+=n.bytes,2*(this.takenBytes-this.creditedBytes)<e)?null:this.creditedBytes=this.takenBytes}}const ju=200;class jM{constructor(t){this.maxBytes=t}kept=new Map;bytes=0;get size(){return this.kept.size}put(t,e){this.erase(t),this.kept.set(t,{...e,payload:e.payload.slice()}),this.bytes+=e.payload.length+ju;for(const n of this.kept.keys()){if(this.bytes<=this.maxBytes)break;this.erase(n)}}find(t){return this.kept.get(t)}erase(t){const e=this.kept.get(t);e!==void 0&&(this.kept.delete(t),this.bytes-=e.payload.length+ju)}clear(){this.kept.clear(),this.bytes=0}entries(){return this.kept}}const ty=32,Fo=16,Oo=ty/4,ip=0,sp=2,rp=4,Ai=6,ap=0,op=6,da=8,lc=10,lp=12,fa=14,ns=16,cp=18,hp=22,up=24,zr=[ap,op,da,lc,lp,fa,ns,cp,hp,up].reduce((i,t)=>i|3<<t,0),Da=2,Na=4,dp=20,as=26,cc=28,$c=[[cp,op],[cc,lc],[fa,da],[lp,up],[as,ap],[hp,lc],[fa,ns],[da,ns],[cc,ns],[fa,Da],[da,Na],[ns,Da],[ns,Na]],Ii=16843009,td=2139062143,ed=-2139062144,pa=(i,t)=>{const e=(i|ed)-t>>>7&Ii,n=(t|ed)-i>>>7&Ii;return e+(n^Ii)},Gr=1<<ip|1<<sp,nd=3<<rp,Hr=3<<as|3<<cc;class ey{even=new Int32Array(Fo);odd=new Int32Array(Fo);make(t,e,n,s,r,a){const{even:o,odd:l}=this,c=a<<dp;let h=t[e],u=h<<24,d=0,f=0,m=0;for(let x=0;x<=Oo;x=x+1|0){let g=Gr|d>>>24&nd|Gr<<8,p=0;if(x<Oo){const S=x<Oo-1?t[e+x+1|0]:Math.imul(h>>>24,Ii),T=t[n+x|0],M=pa(h,h<<8|u>>>24),A=pa(h>>>16|S<<16,h),E=h-T,v=(E+td>>>7&Ii)+(E+td-Ii>>>7&Ii);g=r[x]<<ip|M<<sp|v<<rp,p=A|pa(t[s+x|0],T)<<2,u=h,h=S}if(x===0)m=Gr<<Ai|Gr|g&nd,m=m<<Ai|g&255,m=m<<Ai|g>>>8&255;else{const S=(x<<1)-2;m=m<<Ai|d>>>16&255,o[S]=m&zr|f<<as&Hr|c,m=m<<Ai|d>>>24,l[S]=m&zr|f<<as-8&Hr|c,m=m<<Ai|g&255,o[S+1]=m&zr|f<<as-16&Hr|c,m=m<<Ai|g>>>8&255,l[S+1]=m&zr|f<<as-24&Hr|c}d=g,f=p}}addSymbols(t){const{odd:e}=this;let n=t[0];for(let s=0;s<Fo;s=s+2|0){const r=t[(s>>1)+1];e[s]=e[s]|(n&3)<<Da|(n>>>16&3)<<Na,e[s+1]=e[s+1]|(n>>>16&3)<<Da|(r&3)<<Na,n=r}}}const ny=[23,41,65,96,118,143,167,193,209,227,243,246,250,253,252,253],iy=[250,253,253,252,254,254,255,255,254,255,255,255,255,255,255,255],sy=[1,10,11,26,44,55,75,121,145,171,194,228,235,245,253,255],ry=[`41 52 53 40 54 68 55 40 53 54 47 40 40 40 40 40
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
0 0 0 0 1 0 0 0 0 0 0 0 0 0 0 0`],ay=Uint8Array.from($c,([i])=>i),oy=Uint8Array.from($c,([,i])=>i),ly=dp,cy=9,is=16;function hy(i){const t=i.trim().split(/\s+/).map(Number);return Int32Array.from({length:t.length/2},(e,n)=>{const s=n>>4<<5|n&15;return t[s]<<16|t[s+16]&65535})}const fp=16,$e=32-fp,li=(1<<$e)-1,ko=1<<31,Ls=-1640531535,id=16;class sd{cache=new Int32Array(1<<fp).fill(ko);weights;pairs;constructor(t){this.weights=ry.filter((e,n)=>n%2===1===t).map(hy),this.pairs=t?$c.length:cy}look(t,e){const{cache:n}=this;let s=0,r=0,a=0;for(let o=0;o<id;o=o+4|0)r=Math.imul(t[o],Ls),a=n[r>>>$e],s|=a^r&li,e[o]=a>>>$e<<8,r=Math.imul(t[o+1],Ls),a=n[r>>>$e],s|=a^r&li,e[o+1]=a>>>$e<<8,r=Math.imul(t[o+2],Ls),a=n[r>>>$e],s|=a^r&li,e[o+2]=a>>>$e<<8,r=Math.imul(t[o+3],Ls),a=n[r>>>$e],s|=a^r&li,e[o+3]=a>>>$e<<8;(s&(li|ko))!==0&&this.fill(t,e)}fill(t,e){const{cache:n}=this;for(let s=0;s<id;++s){const r=Math.imul(t[s],Ls);let a=n[r>>>$e];((a^r&li)&(li|ko))!==0&&(a=this.classOf(t[s])<<$e|r&li,n[r>>>$e]=a),e[s]=a>>>$e<<8}}classOf(t){const{pairs:e}=this,n=this.weights[t>>>ly&3];let s=0,r=0;for(let a=0;a<e;a=a+1|0){const o=n[a<<4|t>>>ay[a]&3|(t>>>oy[a]&3)<<2];s=Math.max(-128,Math.min(127,s+(o>>16)|0)),r=Math.max(-128,Math.min(127,r+(o<<16>>16)|0))}return(Math.max(s,0)>>3)*is+(Math.max(r,0)>>3)}}function uy(){const i=new Int32Array(is*is<<8);for(let t=0;t<is;++t){const e=ny[t],n=iy[t];for(let s=0;s<is;++s){const r=e+1+((n-e-2)*sy[s]>>8),a=t*is+s<<8;$a(i.subarray(a,a+256),[e,r-e,n-r,256-n])}}return i}const ve=32,en=ve*ve,ts=64,dy=oe,Bo=0,fy=1,Ps=2,Is=ve/4,yn=16843009,zo=2139062143,Ds=-2139062144;class py{even=new sd(!1);odd=new sd(!0);slots=uy();planes=new Uint8Array(en*ts+ve);planeWords=new Int32Array(this.planes.buffer);keys=new ey;intervals=new Int32Array(oe);symbols=new Uint8Array(ve+4);symbolWords=new Int32Array(this.symbols.buffer);stepSigns=new Int32Array(Is);stepSignBytes=new Uint8Array(this.stepSigns.buffer);firstOfHeight=new Int32Array(ve+1);nextOfHeight=new Int32Array(en*ts);ids=[];decode(t){const e=t.next,n=t.number(),s=n>ts+1&&n<=ts+oe;let r=[];if(!s&&(t.next=e,r=t.materials(ts),rd(r),r.length===1))return t.checkAllRead(),r[0];const a=(s?n-ts:r.length)-1;t.takeStates();for(let o=1;o<=a;++o)this.readPlane(t,o*en);return t.checkAllRead(),s?(r=gy(t,a+1),rd(r)):t.checkFinalStates(),this.ids=r,null}readPlane(t,e){const n=my(t);this.stepSigns.fill(yn);let s=e-en,r=Ps;for(let a=0;a<ve;++a){const o=e+a*ve,l=o-en;this.keys.make(this.planeWords,s>>2,(a===0?l:l-ve)>>2,l>>2,this.stepSigns,r),this.readSymbols(t,this.even,this.keys.even,0),this.keys.addSymbols(this.symbolWords),this.readSymbols(t,this.odd,this.keys.odd,1);const c=this.readRow(t,o,r);if(t.checkRead(),c)throw new Yt("bad_number");r=a+1<ve&&n>>>a+1&1?fy:Bo,s=o}}readSymbols(t,e,n,s){const{symbols:r,slots:a,intervals:o}=this,{bytes:l,states:c}=t;e.look(n,o);let h=t.next,u=0,d=0,f=0,m=s;for(let x=0;x<dy;x=x+4|0)u=c[x],d=a[o[x]+(u&255)|0],u=Math.imul(d>>16,u>>8)+(u&255)-(d>>8&255)|0,f=u-256>>>31,c[x]=u<<(f<<3)|l[h]&-f,h=h+f|0,r[m]=d,u=c[x+1],d=a[o[x+1]+(u&255)|0],u=Math.imul(d>>16,u>>8)+(u&255)-(d>>8&255)|0,f=u-256>>>31,c[x+1]=u<<(f<<3)|l[h]&-f,h=h+f|0,r[m+2]=d,u=c[x+2],d=a[o[x+2]+(u&255)|0],u=Math.imul(d>>16,u>>8)+(u&255)-(d>>8&255)|0,f=u-256>>>31,c[x+2]=u<<(f<<3)|l[h]&-f,h=h+f|0,r[m+4]=d,u=c[x+3],d=a[o[x+3]+(u&255)|0],u=Math.imul(d>>16,u>>8)+(u&255)-(d>>8&255)|0,f=u-256>>>31,c[x+3]=u<<(f<<3)|l[h]&-f,h=h+f|0,r[m+6]=d,m=m+8|0;t.next=h}readRow(t,e,n){const{planeWords:s,symbolWords:r,stepSigns:a}=this,o=e-en>>2,l=n===Ps?o:e-ve>>2,c=n===Ps?o:e-en-ve>>2,h=e>>2;let u=0,d=67305985,f=Ds;for(let m=0;m<Is;m=m+1|0){const x=r[m];if((x&x>>1&yn)!==0)return this.readRowWithOthers(t,e,n);const g=yn+(x&yn)-(x>>1&yn);let p=g,S=yn;n!==Bo&&(p=Math.imul(g,yn)+u,u=Math.imul(p>>>24,yn),S=d,d+=4*yn);const T=s[o+m|0],M=s[l+m|0],A=(M|Ds)-T,E=(M^s[c+m|0])+zo>>>7,v=A&Math.imul(A>>>7&E&yn,127),y=(T+v|Ds)+p-S;f&=y-T&(Ds|538976288)-(y&zo)&y,s[h+m|0]=y&zo,a[m]=pa(p,S)}return f!==Ds}readRowWithOthers(t,e,n){const{planes:s,symbols:r,stepSignBytes:a}=this,{bytes:o}=t,l=e-en,c=n===Ps?l:e-ve,h=n===Ps?l:l-ve;let u=0,d=!1;for(let f=0;f<ve;++f){const m=r[f],x=m===3?o[t.next++]<<24>>24:m===2?-1:m;u=n===Bo?x:u+x;const g=s[l+f],p=s[c+f],S=(p===s[h+f]||p<g?g:p)+u;d||=S<g||S>ve,s[e+f]=d?g:S,a[f]=u>0?2:u<0?0:1}return d}expand(t){const{ids:e,planeWords:n,firstOfHeight:s,nextOfHeight:r}=this;s.fill(-1);for(let a=e.length-1;a>0;--a){const o=a*Is*ve;for(let l=o;l<o+Is*ve;++l){const c=n[l];if(!(a+1<e.length&&c===n[l+Is*ve]))for(let h=0;h<4;++h){const u=c>>>8*h&255;r[4*l+h]=s[u],s[u]=4*l+h}}}t.fill(e[0],0,en);for(let a=0;a<ve;++a){const o=a*en;a>0&&t.copyWithin(o,o-en,o);for(let l=s[a];l>=0;l=r[l])t[o+(l&en-1)]=e[l>>10]}}}function my(i){const{bytes:t}=i,e=t[i.next++];let n=0;for(let s=0;s<4;++s)e>>s&1&&(n|=t[i.next++]<<8*s);if(i.checkRead(),e>15||(n&1)!==0)throw new Yt("bad_number");return n}function rd(i){for(let t=1;t<i.length;++t)if(i[t]===i[t-1])throw new Yt("bad_materials")}function gy(i,t){const e=new Uint8Array(oe);for(let r=0;r<oe;++r){const a=i.states[r]-256;if(a>255)throw new Yt("bad_ending");e[r]=a}const n=[];let s=0;for(let r=0;r<t;++r){let a=0;for(let o=0;;o+=7){if(s===oe||o>14)throw new Yt("bad_ending");const l=e[s++];if(a|=(l&127)<<o,!(l>=128)){if(l===0&&o>0||a>65535)throw new Yt("bad_ending");break}}n.push(a)}for(;s<oe;++s)if(e[s]!==0)throw new Yt("bad_ending");return n}function pp(i,t,e,n){for(let a=0;a<e;++a)n[a]=i.read(t,a);let s=0,r=0;for(let a=0;a<e;++a){const o=n[a];if(o<2)continue;for(;s<o-1;)r|=i.bytes[i.next++]<<s,s+=8;const l=1<<o-1;n[a]=l|r&l-1,r>>>=o-1,s-=o-1}}const ad=256;class mp{ids=new Uint16Array(ad);slots=new Int32Array(256);take(t){const e=t.materials(ad);for(let s=1;s<e.length;++s)if(e[s]===e[0]||s>1&&e[s]<=e[s-1])throw new Yt("bad_materials");if(t.left()<e.length)throw new Yt("truncated");const n=e.map((s,r)=>t.bytes[t.next+r]+1);$a(this.slots,n),this.ids.set(e),t.next+=e.length}read(t,e){return this.ids[t.read(this.slots,e)]}}const Vr=32768,Go=16;class vy{materials=new mp;digits=new Int32Array(256);lengths=new Int32Array(oe);decode(t,e){this.materials.take(t);const n=t.number(),s=n===Vr;if(!s){if(t.left()<Go)throw new Yt("truncated");$a(this.digits,t.bytes.subarray(t.next,t.next+Go)),t.next+=Go}t.takeStates(),s?this.readSingle(t,e):this.readRuns(t,n,e),t.checkAllRead(),t.checkFinalStates()}readSingle(t,e){for(let n=0;n<Vr;++n)e[n]=this.materials.read(t,n%oe),n%256===255&&t.checkRead()}readRuns(t,e,n){let s=0;for(let r=e;r>0;r-=oe){const a=Math.min(r,oe);pp(t,this.digits,a,this.lengths);let o=!1;for(let l=0;l<a;++l){const c=this.materials.read(t,l),h=s+this.lengths[l]+1;o||=h>Vr,!o&&(h===s+1?n[s]=c:n.fill(c,s,h),s=h)}if(t.checkRead(),o)throw new Yt("bad_number")}if(s!==Vr)throw new Yt("bad_number")}}const _y=[60,10,11,12,17,12,13,17,22,24,20,15,11,6,4,2],xy=`
53 85 199 28 163 242 50 180 206 83 153 208 43 218 236 91 198 217 110 180 237 122 229 245
134 210 236 151 250 253 151 173 218 21 46 248 8 20 28 15 28 42 18 254 255 44 85 240
53 95 131 22 71 83 49 252 253 59 241 245 21 254 255 162 203 234 100 123 252 81 237 247
35 251 252 62 135 230 122 141 251 115 135 252 59 246 252 199 211 231 8 251 253 105 140 250
69 251 255 116 249 252 166 220 221 75 254 255 130 178 201 146 233 239 164 223 244 158 240 249
189 234 238 183 236 248 188 209 247 189 252 253 200 235 247 209 247 250 206 253 254 216 235 245
223 253 254 222 245 246 229 249 252 232 254 255 240 254 255 241 248 249 228 233 234 245 254 255
240 244 250 249 250 251 250 254 255 252 254 255 253 254 255 132 182 228
`,wy=[`5555777d777ddfhk577d7bfebdbhfjjm57797dbh7bjefjjp7999bdhkb9hkenna
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
54NNaaaaaNaaaaaa2PdaaaaaaZaaaaaaPfPaaaaaa9aaaaaa6aahaaaaaaaaaaaa`],Ho=1<<30;class Sy{gap=Ho;counts=new Int32Array(256);gaps=new Int32Array(oe);ids=new Int32Array(oe);materials;inGroup=0;taken=0;left=0;constructor(){$a(this.counts,_y)}begin(t,e,n){this.materials=e,this.left=n,this.readGroup(t)}take(t){const e=this.ids[this.taken++];return this.taken<this.inGroup?this.gap=this.gaps[this.taken]:this.readGroup(t),e}checkAllTaken(){if(this.gap<Ho-32768)throw new Yt("bad_number")}readGroup(t){const e=Math.min(this.left,oe);if(this.taken=0,this.inGroup=e,this.left-=e,this.gap=Ho,e!==0){pp(t,this.counts,e,this.gaps);for(let n=0;n<e;++n)this.ids[n]=this.materials.read(t,n);this.gap=this.gaps[0]}}}const od=32;function My(i,t,e,n,s,r,a,o){const l=a===od-1?a:a+1,c=a===0?0:a-1,h=i[e+a],u=i[n+a],d=i[s+a],f=i[r+a],m=u===d?h:u,x=u===d?u:h;let g=0,p=-1,S=-1;for(let T=a&1?0:2;T<10;++T){let M;switch(T){case 0:case 1:{const A=i[t+a-1],E=a===od-1?A:i[t+a+1];M=(m===E||m!==A&&x===E)===(T===0)?E:A;break}case 2:M=m;break;case 3:M=x;break;case 4:M=i[e+l];break;case 5:M=i[e+c];break;case 6:M=i[n+l];break;case 7:M=i[n+c];break;case 8:M=f;break;default:M=d}if(!(M===p||M===S)){if(g===o)return M;g===0?p=M:S=M,++g}}return-1}const yy=384;function Ey(i){return i<=57?i-48:i<=90?i-65+10:i-97+36}function by(){const i=xy.trim().split(/\s+/).map(Number);return wy.map(t=>{const e=t.replace(/\s/g,"");return Int32Array.from({length:yy},(n,s)=>{const r=3*Ey(e.charCodeAt(s));return i[r]|i[r+1]<<8|i[r+2]<<16})})}const kt=32,En=kt*kt,Ty=94,Wr=1431655765,Ay=-1431655766,qe=-1,Vo=-1,fn=16,Wo=fn*(kt/2);class Ry{intervals=by();materials=new mp;exceptions=new Sy;buffer=new ArrayBuffer((En+1)*kt*2);voxels=new Uint16Array(this.buffer);pairs=new Uint32Array(this.buffer);rowMaterial=new Int32Array(En+1);equalsWest=new Int32Array(En+1);equalsNorth=new Int32Array(En+1);equalsBelow=new Int32Array(En+1);north=new Int32Array(fn);below=new Int32Array(fn);belowNorth=new Int32Array(fn);belowSouth=new Int32Array(fn);same=new Int32Array(fn);upright=new Int32Array(fn);level=new Int32Array(fn);levelSouth=new Int32Array(fn);full=new Int32Array(fn);quiet=new Uint8Array(fn);contexts=new Int32Array(Wo);places=new Int32Array(Wo);escapes=new Int32Array(Wo);coded=0;decode(t,e){this.materials.take(t);const n=t.number();if(t.left()<1+2*oe)throw new Yt("truncated");const s=this.intervals[t.bytes[t.next++]];if(s===void 0)throw new Yt("bad_number");t.takeStates(),this.begin(this.materials.ids[0]),this.exceptions.begin(t,this.materials,n);for(let r=0;r<Ty;++r){const a=Math.max(0,r-kt+2>>1),l=Math.min(kt-1,r>>1)-a+1,c=a*kt+r-2*a;this.coded=0;for(let h=0;h<l;++h)this.beginRow(t,h,c+30*h);this.readBatch(t,s),this.coded=0;for(let h=0;h<l;++h)this.finishRow(t,h,c+30*h);this.readBatch(t,s);for(let h=0;h<l;++h)this.compareRow(h,c+30*h)}this.exceptions.checkAllTaken(),t.checkAllRead(),t.checkFinalStates(),e.set(this.voxels.subarray(0,En*kt))}begin(t){this.voxels.fill(t,En*kt),this.rowMaterial[En]=t,this.equalsWest[En]=qe}beginRow(t,e,n){const s=n&kt-1;let r=n-1,a=n-kt,o=a-1,l=a+1,c=qe,h=qe,u=qe,d=qe;n<kt?(s===0&&(r=En),a=o=l=r):(s===0?r=o=a:(h=this.equalsBelow[r],u=this.equalsNorth[a],c=this.equalRows(r,a)),s===kt-1?l=a:d=this.equalsNorth[l]);const f=this.equalsWest[r],m=this.equalsWest[a],x=f>>>1|2147483648,g=m>>>1|2147483648,p=c&h&d&f&x&m&g;this.north[e]=r,this.below[e]=a,this.belowNorth[e]=o,this.belowSouth[e]=l,this.same[e]=c,this.upright[e]=h,this.level[e]=u,this.levelSouth[e]=d,this.full[e]=p,this.copyBase(n,r,a,u);const{exceptions:S}=this,T=p===qe?16:ld(p&Wr);if(S.gap>=T?(S.gap-=T,this.quiet[e]=p===qe?1:0):(this.takeExceptions(t,n,p&Wr,T),this.quiet[e]=0),p===qe)return;const{voxels:M,contexts:A,places:E}=this;let v=this.coded;for(let y=~p&Wr;y!==0;y&=y-1){const N=31-Math.clz32(y&-y),P=(f>>>N&1)<<2|(x>>>N&1)<<3|(m>>>N&1)<<4|(g>>>N&1)<<5,D=h>>>N&1,B=d>>>N&1,W=D|B<<1|P,C=64|u>>>N&1|D<<1|B<<2|Cy(M[l*kt+N]-M[r*kt+N])<<3|(P&P<<1&8)<<1|P&P<<1&32;A[v]=C^(C^W)&-(c>>>N&1),E[v++]=e<<16|n*kt+N}this.coded=v}finishRow(t,e,n){const{voxels:s,exceptions:r,contexts:a,places:o}=this;if(this.quiet[e]){r.gap>=16?r.gap-=16:(this.quiet[e]=0,this.takeExceptions(t,n,Ay,16));return}const l=this.north[e]*kt,c=this.below[e]*kt,h=this.same[e],u=this.upright[e],d=this.level[e],f=this.levelSouth[e],m=this.full[e],x=this.equalsWest[this.north[e]],g=this.equalsWest[this.below[e]],p=n*kt;let S=0,T=this.coded,M=s[p];for(let E=1;E<kt;E+=2){const v=E===kt-1?M:s[p+E+1],y=s[l+E];if(M===v){s[p+E]=M;const N=h>>>E&1;if(N&&y===M)m>>>E&1?S|=1<<E:(a[T]=128|u>>>E&1|(f>>>E&1)<<1|(x>>>E&1)<<2|(E===kt-1?1:x>>>E+1&1)<<3|(g>>>E&1)<<4|(E===kt-1?1:g>>>E+1&1)<<5,o[T++]=e<<16|p+E);else{const P=s[c+E],D=d>>>E&1,B=D?y:P,W=D?P:y;a[T]=192|(B===M?1:0)|(W===M?2:0)|N<<2|(u>>>E&1)<<3|D<<4|(f>>>E&1)<<5,o[T++]=e<<16|p+E}}else{const N=s[c+E],P=d>>>E&1,D=P?y:N,B=P?N:y,W=D===v||D!==M&&B===v,C=W?v:M,H=W?M:v;s[p+E]=C,a[T]=256|(D===C?1:0)|(B===C?2:0)|(D===H?4:0)|(B===H?8:0)|(u>>>E&1)<<4|P<<5|(f>>>E&1)<<6,o[T++]=e<<16|p+E}M=v}this.coded=T;const A=ld(S);r.gap>=A?r.gap-=A:this.takeExceptions(t,n,S,A)}takeExceptions(t,e,n,s){const{exceptions:r}=this;for(;r.gap<s;){for(let o=r.gap;o>0;--o)n&=n-1;const a=31-Math.clz32(n&-n);n&=n-1,s-=r.gap+1,this.voxels[e*kt+a]=r.take(t)}r.gap-=s}readBatch(t,e){const{contexts:n,places:s,voxels:r,escapes:a,coded:o}=this,{bytes:l,states:c}=t;let h=t.next,u=0,d=!1;for(let f=0;f<o;++f){const m=e[n[f]],x=f&oe-1;let g=c[x];const p=g&255,S=m&255;if(p<S)g=S*(g>>8)+p;else{const M=m>>8&255,A=m>>16,E=s[f];if(p>=A)g=(256-A)*(g>>8)+p-A,a[u++]=E&65535;else{let v=1;p<M?g=(M-S)*(g>>8)+p-S:(v=2,g=(A-M)*(g>>8)+p-M);const y=this.candidate(E,v);y<0?d=!0:r[E&65535]=y}}const T=g-256>>>31;c[x]=g<<(T<<3)|l[h]&-T,h+=T}t.next=h;for(let f=0;f<u;++f)r[a[f]]=this.materials.read(t,f&oe-1);if(t.checkRead(),d)throw new Yt("bad_number")}candidate(t,e){const n=t>>>16,s=t&65535;return My(this.voxels,s&-32,this.north[n]*kt,this.below[n]*kt,this.belowNorth[n]*kt,this.belowSouth[n]*kt,s&kt-1,e)}copyBase(t,e,n,s){const{pairs:r,voxels:a}=this,o=t*(kt/2),l=(s===qe?e:n)*(kt/2);for(let c=0;c<kt/2;++c)r[o+c]=r[l+c];if(s!==qe)for(let c=s&Wr;c!==0;c&=c-1){const h=31-Math.clz32(c&-c);a[t*kt+h]=a[e*kt+h]}}compareRow(t,e){const n=this.north[t];if(this.quiet[t]){this.rowMaterial[e]=this.rowMaterial[n],this.equalsWest[e]=this.equalsNorth[e]=this.equalsBelow[e]=qe;return}const{pairs:s}=this,r=this.below[t],a=e*(kt/2),o=n*(kt/2),l=r*(kt/2);let c=s[a]<<16,h=0,u=0,d=0;for(let f=0;f<kt/2;++f){const m=s[a+f]|0;h|=Xr(m,m<<16|c>>>16)<<2*f,u|=Xr(m,s[o+f])<<2*f,d|=Xr(m,s[l+f])<<2*f,c=m}this.equalsWest[e]=h,this.equalsNorth[e]=u,this.equalsBelow[e]=d,this.rowMaterial[e]=h===qe?c>>>16:Vo}equalRows(t,e){const n=this.rowMaterial[t];if(n!==Vo&&this.rowMaterial[e]!==Vo)return n===this.rowMaterial[e]?qe:0;const{pairs:s}=this,r=t*(kt/2),a=e*(kt/2);let o=0;for(let l=0;l<kt/2;++l)o|=Xr(s[r+l],s[a+l])<<2*l;return o}}function Xr(i,t){const e=i^t;return(e&65535)-1>>>31|(e>>>16)-1>>>30&2}function Cy(i){return(i|-i)>>>31^1}function ld(i){return i-=i>>>1&1431655765,i=(i&858993459)+(i>>>2&858993459),Math.imul(i+(i>>>4)&252645135,16843009)>>>24}const Ly=32768,gp=2*Ly,bn=16,Xo=16,cd=gp/64,qr=Uint8Array.from("b8fe6c3923a44bbe7c01812cf721ad1cded46de9839097db7240a4a4b7b3671fcb79e64eccc0e578825ad07dccff7221b8084674f743248ee03590e6813a264c3c2852bb91c300cb88d0658b1b532ea371644897a20df94e3819ef46a9deacd8a8fa763fe39c343ff9dcbbc7c70b4f1d8a51e04bcdb45931c89f7ec9d9787364eac5ac8334d3ebc3c581a0fffa1363eb170ddd51b7f0da49d316552629d4689e2b16be587d47a1fc8ff8b8d17ad031ce45cb3a8f95160428afd7fbcabb4b407e".match(/../g),i=>parseInt(i,16));function Ns(i,t){return Int32Array.from({length:t},(e,n)=>{const s=i+4*n;return qr[s]|qr[s+1]<<8|qr[s+2]<<16|qr[s+3]<<24})}const Py=[3266489917,0,2246822535,2654435761,668265295,3266489917,2654435833,374761393,3266489955,2246822519,2246822519,0,374761413,668265263,2654435761,0],qo=-1640531535;class Iy{words=new Int32Array(gp/4);voxels=new Uint16Array(this.words.buffer);sums=new Int32Array(16);stripeSecrets=Ns(0,bn+2*(Xo-1));lastSecret=Ns(121,bn);scrambleSecret=Ns(128,bn);lowSecret=Ns(11,bn);highSecret=Ns(117,bn);hash(){this.sums.set(Py);for(let n=0;n<cd-1;++n){const s=n%Xo;this.accumulate(n*bn,this.stripeSecrets,2*s),s===Xo-1&&this.scramble()}this.accumulate((cd-1)*bn,this.lastSecret,0);const t=this.merge(this.lowSecret,-897122304,2041677291);return this.merge(this.highSecret,347144191,1371723819)+t}accumulate(t,e,n){const{words:s,sums:r}=this;for(let a=0;a<bn;a+=2){const o=s[t+a],l=s[t+a+1],c=o^e[n+a],h=l^e[n+a+1],u=Math.imul(c&65535,h>>>16),d=Math.imul(c>>>16,h&65535),f=(Math.imul(c&65535,h&65535)>>>16)+(u&65535)+(d&65535),m=Math.imul(c,h),x=Math.imul(c>>>16,h>>>16)+(u>>>16)+(d>>>16)+(f>>>16);let g=r[a]+m|0;r[a+1]=r[a+1]+x+($o(g,m)?1:0),r[a]=g;const p=a^2;g=r[p]+o|0,r[p+1]=r[p+1]+l+($o(g,o)?1:0),r[p]=g}}scramble(){const{sums:t,scrambleSecret:e}=this;for(let n=0;n<bn;n+=2){const s=t[n+1],r=t[n]^s>>>15^e[n];t[n]=Math.imul(r,qo),t[n+1]=hc(r,qo)+Math.imul(s^e[n+1],qo)}}merge(t,e,n){const{sums:s}=this;let r=e|0,a=n|0;for(let l=0;l<bn;l+=4){const[c,h,u,d]=Dy(s[l]^t[l],s[l+1]^t[l+1],s[l+2]^t[l+2],s[l+3]^t[l+3]),f=c^u;r=r+f|0,a=a+(h^d)+($o(r,f)?1:0)|0}r^=a>>>5;const o=Math.imul(r,2654435833);return a=hc(r,-1640531463)+Math.imul(a,2654435833)+Math.imul(r,374761361)|0,r=o^a,hd(a)+hd(r)}}function $o(i,t){return(i^2147483648)<(t^2147483648)}function hc(i,t){const e=Math.imul(i&65535,t>>>16),n=Math.imul(i>>>16,t&65535),s=(Math.imul(i&65535,t&65535)>>>16)+(e&65535)+(n&65535);return Math.imul(i>>>16,t>>>16)+(e>>>16)+(n>>>16)+(s>>>16)|0}function Dy(i,t,e,n){const s=[[0,i,e],[1,i,n],[1,t,e],[2,t,n]],r=[0,0,0,0,0];for(const[a,o,l]of s)r[a]+=Math.imul(o,l)>>>0,r[a+1]+=hc(o,l)>>>0;for(let a=0;a<4;++a)r[a+1]+=Math.floor(r[a]/4294967296),r[a]=r[a]|0;return[r[0],r[1],r[2],r[3]]}function hd(i){return(i>>>0).toString(16).padStart(8,"0")}let $r;function vp(i){return $r??=new Iy,i.voxels===null?$r.voxels.fill(i.uniform):$r.voxels.set(i.voxels),$r.hash()}const Ua=32768;class Ny{source=new RM;layers=new py;volume=new Ry;runs=new vy}let ud;function _p(i,t={}){if(t.into!==void 0&&t.into.length!==Ua)throw new At("out_of_range",`decodeChunk: into must have ${Ua} voxels, not ${t.into.length}`);if(!ArrayBuffer.isView(i)||i.BYTES_PER_ELEMENT!==1)throw new At("out_of_range","decodeChunk: a payload is a Uint8Array");const e=Uy(i,t.into);if(t.hash!=null&&vp(e)!==t.hash)throw new Yt("bad_hash");return e}function Uy(i,t){if(i.length===0)throw new Yt("empty");const e=i[0];if(e!==3&&e!==4)throw new Yt("unknown_version");if(i.length<2)throw new Yt("truncated");if(i.length>Vc)throw new Yt("too_long");const n=i[1];if(e===3?n!==0:n===0||n>3)throw new Yt("unknown_encoding");ud??=new Ny;const{source:s,layers:r,volume:a,runs:o}=ud;s.begin(i);const l=e===3;if(l){const h=r.decode(s);if(h!==null)return{uniform:h,voxels:null}}const c=t??new Uint16Array(Ua);return l?r.expand(c):n===2?Fy(i,c):n===1?a.decode(s,c):o.decode(s,c),{uniform:null,voxels:c}}function Fy(i,t){if(i.length<Vc)throw new Yt("truncated");for(let e=0;e<Ua;++e)t[e]=i[2+2*e]|i[3+2*e]<<8}const Us=32768;function Oy(i,t){let e=0;const n=l=>{let c=0;for(let h=0;h<35;h+=7){const u=i[e++];if(u===void 0)throw bt("runs of voxels that end too early");if(c+=(u&127)*2**h,!(u>=128)){if(u===0&&h>0||c>l)break;return c}}throw bt("runs of voxels with a number that is past its range, or longer than need be")},s=[];for(let l=n(Us);l>0;--l){const c=n(65535);if(s.length>0&&c<=s.at(-1))throw bt("runs of voxels whose materials do not rise");s.push(c)}const r=new Set;let a=0,o=-1;for(let l=n(Us);l>0;--l){const c=n(Us-1);if(s.length===0)throw bt("runs of voxels without a material");const h=n(Us*s.length-1),u=h%s.length;if(c===0&&u===o)throw bt("runs of voxels that are one run");const d=a+c;if(a=d+Math.floor(h/s.length)+1,a>Us)throw bt("runs of voxels past the chunk's end");r.add(u),o=u,t(d,a,s[u])}if(r.size!==s.length)throw bt("runs of voxels with a material of no run");if(e!==i.length)throw bt("runs of voxels with bytes after the last")}const ky=32768;class By{cache;constructor(t){this.cache=new jM(t)}keep({key:t,revision:e,hash:n,payload:s,material:r}){r===null&&n!==null?this.cache.put(He(t),{key:t,revision:e,hash:n,payload:s}):this.cache.erase(He(t))}find(t,e){const n=this.cache.find(He(t));return n?.hash===e?n:void 0}known(t,e,n){const s=[],r=Gf(e,n);if(Hf(r)>this.cache.size)for(const[,{key:a,hash:o}]of this.cache.entries())s.length<t&&e.covers(a)&&!n?.covers(a)&&s.push({key:a,hash:o});else Vf(r,a=>{const o=s.length<t?this.cache.find(He(a)):void 0;o!==void 0&&s.push({key:a,hash:o.hash})});return s}edited(t,{key:e,revision:n,previousRevision:s,runs:r}){const a=t.material===null?this.find(e,t.hash)?.payload:nr(t.material);if(a===void 0||r.length===0||s>t.revision)return null;const o=new Uint16Array(ky),l=_p(a,{into:o});l.voxels===null&&o.fill(l.uniform),Oy(r,(h,u,d)=>o.fill(d,h,u));const c=Wc({uniform:null,voxels:o});return{key:e,revision:n,hash:vp({uniform:null,voxels:o}),payload:c,material:Zs(c)}}clear(){this.cache.clear()}}const zy=7/8;class Gy{tokens=1/0;most=1/0;perMs=0;at=0;heldUntil=0;begin({sessionRates:t,addressRates:e},n){this.perMs=0,this.tokens=this.most=1/0;for(const s of[t,e])s===null||s.requests===0||this.perMs>0&&s.requests/1e3>=this.perMs||(this.perMs=s.requests/1e3,this.tokens=this.most=Math.max(1,this.perMs*s.burstMs*zy));this.at=n,this.heldUntil=0}refused(t,e){this.heldUntil=Math.max(this.heldUntil,e+kf(t))}wait(t){this.tokens=Math.min(this.most,this.tokens+(t-this.at)*this.perMs),this.at=t;const e=this.tokens>=1?0:(1-this.tokens)/this.perMs;return Math.ceil(Math.max(e,this.heldUntil-t,0))}take(){this.tokens-=1}}class Hy{open=new Map;lastNonce=0;get isEmpty(){return this.open.size===0}add(t,e,n){return this.open.set(BigInt(++this.lastNonce),{sent:t,resolve:e,reject:n}),this.lastNonce}answered(t,e){const n=this.open.get(t);return n===void 0?null:(this.open.delete(t),n.resolve(e-n.sent),e-n.sent)}refuseOldest(t){const[e]=this.open.entries();e!==void 0&&(this.open.delete(e[0]),e[1].reject(t))}failAll(t){const e=[...this.open.values()];this.open.clear();for(const n of e)n.reject(t)}}class Vy{inFlight=new Map;waiting=[];lastId=0;add(t){this.waiting.push(t)}get inFlightCount(){return this.inFlight.size}next(){const t=this.waiting.shift();if(t===void 0)return null;do this.lastId=this.lastId%2147483647+1;while(this.inFlight.has(this.lastId));return this.inFlight.set(this.lastId,t),{id:this.lastId,request:t}}peek(){return this.waiting[0]}find(t){return this.inFlight.get(t)}take(t){const e=this.inFlight.get(t);return this.inFlight.delete(t),e}putBack(t){const e=this.take(t);e!==void 0&&this.waiting.unshift(e)}putAllBack(){this.waiting=[...this.inFlight.values(),...this.waiting],this.inFlight.clear()}failAll(t){this.putAllBack();const e=this.waiting;this.waiting=[];for(const n of e)n.reject(t)}}class Wy{constructor(t,e,n,s){this.sender=t,this.pace=e,this.requests=n,this.edits=s}viewWaits=!1;timer;stop(){clearTimeout(this.timer),this.timer=void 0,this.viewWaits=!1}later(t){if(this.timer!==void 0){if(t>0)return;clearTimeout(this.timer)}this.timer=setTimeout(()=>{this.timer=void 0,this.now()},t)}now(){const t=this.sender.openWorld();if(t===null)return;const{limits:e}=t,n=e.frameBytes-2*jf;let s=[];const r=()=>{s.length>0&&this.sender.send(vM(s)),s=[]};for(;;){const a=this.pace.wait(performance.now()),o=this.requests.peek()!==void 0&&this.requests.inFlightCount<e.requestsInFlight;if(!this.viewWaits&&!o&&!this.edits.hasNext)break;if(a>0){this.later(a);break}if(this.pace.take(),this.viewWaits){this.viewWaits=!1,this.sender.sendView();continue}if(this.edits.hasNext){const h=this.edits.next(e.frameBytes);h!==null&&this.sender.send(h);continue}const{id:l,request:c}=this.requests.next();c.kind==="chunk"?(s.push({id:l,key:c.key,known:null}),Zf*(s.length+1)>n&&r()):(r(),this.askPlaces(t,n,l,c))}r()}askPlaces({limits:t,fields:e},n,s,r){const a=c=>this.requests.take(s).reject(new At("out_of_range",c)),o=Math.min(t.heightsPerRequest,Math.floor(n/Qf)),l=r.fields.map(c=>e.indexOf(c));r.columns.length>o?a(`${r.columns.length} columns; this server takes ${o}`):l.includes(-1)?a(`no field ${r.fields[l.indexOf(-1)]} here; there are: ${e.join(", ")}`):this.sender.send(_M(s,r.columns,r.looks,l))}}function dd({code:i,text:t,retryAfterMs:e}){const n=`the server says: ${t}`;switch(i){case"version":case"unauthorized":case"forbidden":case"unsupported":return new At("refused",n);case"malformed":case"unexpected":return new At("broken_protocol",n);case"too_large":case"too_many_requests":case"out_of_range":return new At("out_of_range",n);case"overloaded":return new At("overloaded",n,e);case"cancelled":return new At("cancelled",n);case"conflict":case"not_applied":return new At(i,n);case"timeout":return new At("timed_out",n);default:return new At("server_failed",n,e)}}class Xy{constructor(t,e,n){this.tracker=t,this.kept=e,this.receiver=n}completeToTell=!1;refetching=new Map;uniform=new Map;stop(){this.refetching.clear(),this.completeToTell=!1}viewApplied(){this.completeToTell=!1}chunk(t){return this.tracker.shape?.covers(t.key)?(this.receiver.served(),this.kept.keep(t),this.receiver.deliver(t)):!1}unchanged({id:t,key:e,revision:n,hash:s}){if(t!==0)throw bt(`Unchanged as the answer to request ${t}, which knew of no chunk`);if(!this.tracker.shape?.covers(e))return;this.receiver.served(),this.receiver.countUnchanged();const r=this.tracker.find(e);if(r!==void 0&&n<r.revision)return;if(r?.hash===s)return this.tracker.confirm(r,n);const a=this.kept.find(e,s);a===void 0?this.refetch(e):this.receiver.deliver({key:e,revision:n,hash:s,payload:a.payload.slice(),material:null})}editBroadcast(t){const{key:e,revision:n}=t,s=this.tracker.find(e);if(s===void 0||n<=s.revision)return;const r=this.kept.edited(s,t);if(r===null){this.refetch(e);return}this.kept.keep(r),this.receiver.deliver(r)}uniformColumn({x:t,z:e,lod:n,revision:s,runs:r}){for(const a of r){const o=this.uniformPayload(a.material),l=this.tracker.shape;if(l===null)return;const c=l.rows(n,t,e),h=Math.min(c.last,a.lastY);for(let u=Math.max(c.first,a.firstY);u<=h;++u)if(this.receiver.served(),this.receiver.deliver({key:{lod:n,x:t,y:u,z:e},revision:s,hash:null,payload:o.slice(),material:a.material}),this.receiver.world()===null)return}}uniformPayload(t){let e=this.uniform.get(t);if(e===void 0){if(!this.receiver.world().materials.some(({id:n})=>n===t))throw bt(`a UniformColumn of material ${t}, which is not in Welcome`);e=nr(t),this.uniform.set(t,e)}return e}viewComplete(){this.completeToTell=!0;for(const t of this.tracker.missing())this.refetching.has(He(t))||this.refetch(t);this.tellCompleteIfWhole()}tellCompleteIfWhole(){!this.completeToTell||this.refetching.size>0||this.receiver.world()===null||(this.completeToTell=!1,this.receiver.tellComplete())}refetch(t){const e=He(t);if(this.refetching.has(e))return void this.refetching.set(e,!0);this.refetching.set(e,!1),this.receiver.getChunk(t).then(n=>{const s=this.refetching.get(e)??!1;this.refetching.delete(e);const r=this.tracker.find(t)?.revision??-1n;this.tracker.shape?.covers(t)&&n.revision>=r&&this.kept.keep(n),this.receiver.settle(n,this.receiver.deliver(n)),s&&this.receiver.world()!==null&&this.tracker.has(t)&&this.refetch(t),this.tellCompleteIfWhole()},n=>{this.refetching.delete(e),!this.receiver.isClosed()&&(this.tracker.shape?.covers(t)&&this.receiver.failed(n),this.tellCompleteIfWhole())})}}function qy({key:i,revision:t,hash:e,payload:n}){return{key:i,revision:t,hash:e,payload:n,material:Zs(n)}}const Yo=2,fd=4,pd=4096,$y=1<<20,Yy=16<<20,Ky=1e4,md=2e4,Zy=5,Jy=6e4,Qy=8192,jy=2**40;class t1 extends Wf{constructor(t,e){super(t),this.open=e;for(const[n,s]of[["token",t.token],["clientName",t.clientName]]){const r=new TextEncoder().encode(s??"").length;if(r>pd)throw new At("out_of_range",`${n} has ${r} bytes; at most ${pd} are allowed`)}this.kept=new By(t.keepBytes??Yy),this.contents=new Xy(this.tracker,this.kept,{world:()=>this.connected?this.world:null,isClosed:()=>this.isClosed,served:()=>this.backoff.reset(),deliver:n=>this.deliver(n),settle:(n,s)=>this.settle(n,s),getChunk:n=>this.getChunk(n),failed:n=>this.emit("error",n),countUnchanged:()=>void++this.stats.unchangedChunks,tellComplete:()=>this.tellComplete()}),this.attempt()}transport=null;connection=0;reader=new Zu;requests=new Vy;pace=new Gy;kept;pings=new Hy;credit=new QM;viewNumber=0;sentShape=null;contents;edits=new kM(()=>this.connected&&this.sending.later(0));sending=new Wy({openWorld:()=>this.connected&&this.leaving===null?this.world:null,send:t=>this.send(t),sendView:()=>this.sendView()},this.pace,this.requests,this.edits);leaving=null;heardAt=0;deadline;heartbeat;attempt(){const t=++this.connection,e=()=>t===this.connection&&!this.isClosed;this.reader=new Zu,this.credit.begin(),this.leaving=null;const n=this.options.connectTimeoutMs??Ky;this.deadline=setTimeout(()=>{this.drop(new At("timed_out",`no answer from ${ep(this.options.url).map(qc).join(", ")} within ${n/1e3} s: it is away, or this program is too busy`))},n);try{this.transport=this.open({opened:()=>e()&&this.sayHello(),received:s=>e()&&this.receive(s,e),ended:s=>e()&&this.drop(this.leaving??s)})}catch(s){const r=new At("refused",`the connection cannot be opened: ${s.message}`);queueMicrotask(()=>e()&&this.drop(r))}}sayHello(){this.send(gM({protocolMin:Yo,protocolMax:Yo,codecs:[fd],token:this.options.token??"",client:this.options.clientName??"talus-client for JavaScript",windowBytes:this.options.windowBytes??$y}))}send(t){this.stats.sentBytes+=t.length,this.transport?.send(t)}drop(t){this.disconnect(),this.connected&&this.pings.failAll(t),this.lost(t)}disconnect(){++this.connection,clearTimeout(this.deadline),clearInterval(this.heartbeat),this.sending.stop(),this.transport?.close(),this.transport=null,this.contents.stop(),this.sentShape=null,this.requests.putAllBack(),this.edits.connectionEnded()}stopped(){this.disconnect();const t=this.closedError();this.pings.failAll(t),this.requests.failAll(t),this.edits.failAll(t),this.kept.clear()}receive(t,e){this.stats.receivedBytes+=t.length,this.heardAt=performance.now();try{this.reader.push(t,n=>{e()&&this.handle(WM(n),n.length)})}catch(n){if(!(n instanceof At))throw n;e()&&this.drop(n)}}handle(t,e){if(!this.connected){if(t.kind==="welcome")this.handleWelcome(t);else if(t.kind==="error")this.handleFatal(t);else if(t.kind==="go_away")this.handleGoAway(t);else throw bt(`${t.kind} before Welcome`);return}switch(t.kind){case"chunk":return this.handleChunk(t,e);case"unchanged":return this.contents.unchanged(t);case"uniform_column":return this.contents.uniformColumn(t);case"view_complete":return this.handleViewComplete(t);case"heights":return this.handleHeights(t);case"error":return this.handleError(t);case"edit_broadcast":return this.edits.saw(t.revision),this.contents.editBroadcast(t);case"edit_result":return this.backoff.reset(),this.edits.handleResult(t),this.sending.now();case"attached":return this.backoff.reset(),this.edits.handleAttached(t),this.sending.now();case"pong":return this.handlePong(t);case"go_away":return this.handleGoAway(t);default:throw bt(`an unexpected ${t.kind}`)}}handleWelcome({world:t}){if(t.protocol!==Yo||t.codec!==fd)throw bt(`a Welcome for protocol ${t.protocol} and codec ${t.codec}, which were not offered`);clearTimeout(this.deadline),this.pace.begin(t.limits,performance.now()),this.joined(t)}worldKnown(t){t||this.kept.clear(),this.edits.joined(this.world,t);const e=this.world.limits.idleTimeoutMs||md*3;this.heardAt=performance.now(),this.heartbeat=setInterval(()=>this.beat(),Math.max(Zy,Math.min(md,e/3))),this.sending.now()}beat(){const t=performance.now()-this.heardAt;if(t>Jy){this.drop(new At("timed_out",`the server said nothing for ${Math.round(t/1e3)} s`));return}this.pings.isEmpty&&this.ping().catch(()=>{})}handleChunk(t,e){const{id:n,key:s}=t;this.stats.chunkBytes+=e;const r=qy(t);this.credit.owe(r,e),this.edits.saw(r.revision);let a=!1;if(n!==0){const o=this.requests.find(n);if(o?.kind!=="chunk"||!bS(o.key,s))throw bt(`chunk ${He(s)} as the answer to request ${n}, which did not ask for it`);this.requests.take(n),this.backoff.reset(),a=!0,o.resolve(r),this.sending.now()}else a=this.contents.chunk(r);this.settle(r,a)}settle(t,e){(!e||!this.options.manualCredit)&&this.taken(t)}taken(t){if(!this.connected)return;const e=this.credit.taken(t,this.world.limits.windowBytes);e!==null&&this.send(xM(e))}handleViewComplete({number:t}){t!==this.viewNumber||this.sending.viewWaits||this.tracker.view===null||this.contents.viewComplete()}handleHeights({id:t,heightsFx:e,looks:n,values:s}){const r=this.requests.find(t),a=e.length;if(r?.kind!=="places"||r.columns.length!==a)throw bt(`${a} heights as the answer to request ${t}, which did not ask for them`);if(n.length!==(r.looks?a:0)||s.length!==a*r.fields.length)throw bt(`${n.length} looks and ${s.length} values of ${a} columns for request ${t}`);if(n.some(o=>o>=this.world.looks.length))throw bt("a look that is not in Welcome");this.requests.take(t),this.backoff.reset(),r.resolve({heightsFx:e,looks:r.looks?n:null,values:r.fields.length>0?s:null}),this.sending.now()}handlePong({nonce:t}){const e=this.pings.answered(t,performance.now());if(e===null)throw bt("a Pong that no Ping asked for");this.stats.latencyMs=e}handleGoAway({reason:t,retryAfterMs:e}){this.leaving=new At("disconnected",`the server goes away: ${t}`,e)}handleFatal(t){this.leaving=dd(t),this.drop(this.leaving)}handleError(t){const e=dd(t),n=t.code==="overloaded"&&t.retryAfterMs>0;n&&this.pace.refused(t.retryAfterMs,performance.now());const s=t.code==="overloaded"&&(n||this.leaving!==null);switch(t.about){case"request":if(t.requestId>=ua)return this.edits.editRefused(t,e,s),this.sending.now();if(this.requests.find(t.requestId)===void 0)throw bt(`an Error about request ${t.requestId}, which is not in flight`);s?this.requests.putBack(t.requestId):this.requests.take(t.requestId).reject(e),this.sending.now();return;case"view":if(this.sentShape=null,t.viewNumber!==this.viewNumber)return;n?this.sending.viewWaits=!0:this.emit("error",e),this.sending.now();return;case"attach":return this.edits.attachRefused(e,s),this.sending.now();case"view_chunk":t.chunk!==null&&this.tracker.shape?.covers(t.chunk)&&this.contents.refetch(t.chunk);return;case"ping":this.pings.refuseOldest(e);return;case"connection":this.leaving=e;return;default:this.emit("error",e)}}viewApplied(){this.contents.viewApplied(),this.sending.viewWaits=!0,this.viewNumber=this.viewNumber%4294967295+1,this.sending.now()}sendView(){const{view:t,shape:e}=this.tracker,n=this.sentShape;if(this.sentShape=t===null?null:e,t===null){const a={centre:{x:jy,y:0,z:0},horizontalRadius:0,verticalRadius:0};this.send(Vu(a,this.viewNumber,[]));return}const s=(this.world.limits.frameBytes-2*jf)/Jf,r=this.kept.known(Math.min(s,Qy),e,n);this.send(Vu(t,this.viewNumber,r))}getChunk(t){return new Promise((e,n)=>{Bf(t),this.ask({kind:"chunk",key:{...t},resolve:e,reject:n})})}getPlaces(t,e={}){return new Promise((n,s)=>{zf(t);const{looks:r=!1,fields:a=[]}=e;this.ask({kind:"places",columns:[...t],looks:r,fields:[...a],resolve:n,reject:s})})}edit(t){return this.isClosed?Promise.reject(this.closedError()):this.edits.edit(t,this.connected?this.world:null)}editLimits(){return this.isClosed?Promise.reject(this.closedError()):this.edits.askLimits(this.connected?this.world:null)}ask(t){if(this.isClosed)throw this.closedError();this.requests.add(t),this.connected&&this.sending.later(0)}ping(){return new Promise((t,e)=>{if(!this.connected)throw new At("disconnected","ping: the client is not connected");this.pace.take(),this.send(wM(this.pings.add(performance.now(),t,e)))})}}function e1(i){let t=0;return e=>i[t++%i.length](e)}const n1=1;function i1(i,t){const e=t??globalThis.WebSocket;if(e===void 0)throw new At("unreachable","there is no WebSocket here: pass one as the option WebSocket, or connect by tcp:// with talus-client/node");return n=>{const s=new e(i);s.binaryType="arraybuffer";let r=!1;const a=o=>{s.onopen=s.onmessage=s.onclose=null,s.onerror=()=>{},n.ended(o)};return s.onopen=()=>{r=!0,n.opened()},s.onmessage=({data:o})=>{if(o instanceof ArrayBuffer){n.received(new Uint8Array(o));return}a(new At("broken_protocol","the server sent text, where the protocol has bytes only")),s.close()},s.onerror=()=>{},s.onclose=({code:o,reason:l})=>{const c=l===""?`code ${o}`:`${l} (code ${o})`;a(r?new At("disconnected",`the connection to ${i} ended: ${c}`):new At("unreachable",`nobody answers at ${i}${Of(i)}`))},{send:o=>{s.readyState===n1&&s.send(o)},close:()=>{s.onopen=s.onmessage=s.onclose=null,s.onerror=()=>{},s.close()}}}}function s1(i){const t=ep(i?.url),[e]=t.map(np);return t.length===1&&(e.protocol==="http:"||e.protocol==="https:")?new uM(i,e):new t1(i,e1(t.map(n=>r1(n,i))))}function r1(i,t){const e=np(i);if(e.protocol!=="ws:"&&e.protocol!=="wss:")throw new At("unreachable",`url ${qc(i)}: ws:, wss:, and of one server http: and https: are known here; tcp: and tls: in talus-client/node`);return e.pathname.endsWith("/v1/stream")||(e.pathname=`${e.pathname.replace(/\/$/,"")}/v1/stream`),i1(e.href,t.WebSocket)}function Fa(i,t=null){const{uniform:e,voxels:n}=_p(i,{hash:t});return n??e}class a1{layers=new Map;revision=null}const o1=32768,Fs=({x:i,y:t,z:e})=>`${i}/${t}/${e}`;function gd({payload:i,material:t}){const e=t??Fa(i);return typeof e=="number"?new Uint16Array(o1).fill(e):e}const l1=(i,t)=>i.every((e,n)=>e===t[n]);class c1{constructor(t){this.host=t}covered=new Map;get size(){return this.covered.size}begin(t){const e=new a1,n=new Map;for(const{x:s,y:r,z:a,material:o}of t){const l={x:Math.floor(s/32),y:Math.floor(r/32),z:Math.floor(a/32)},c=Fs(l);let h=e.layers.get(c);h===void 0&&(e.layers.set(c,h=new Map),n.set(c,l)),h.set(((r-l.y*32)*32+a-l.z*32)*32+s-l.x*32,o)}for(const[s,r]of n){const a=this.cover(s,r);if(a===null){e.layers.delete(s);continue}a.predictions.push(e),this.refresh(s,a)}return e}settled(t,e,n){t.revision=n?e:0n,this.eachOf(t,s=>[...t.layers.get(Fs(s.place))].every(([o,l])=>s.voxels[o]===l)||n&&s.revision>=e)}refused(t){this.eachOf(t,()=>!0)}arrived(t,e,n){const s=Fs(t),r=this.covered.get(s);return r===void 0?n:(this.put(r,e,n),this.compose(s,r))}behind(t){return t.revision===null?[]:[...this.covered.values()].filter(({predictions:e})=>e.includes(t)).map(({place:e})=>e)}resolved(t,e,n,s){const r=Fs(e),a=this.covered.get(r);a!==void 0&&(a.predictions=a.predictions.filter(o=>o!==t),n>=a.revision&&this.put(a,n,s),this.refresh(r,a))}left(t){this.covered.delete(Fs(t))}clear(){this.covered.clear()}cover(t,e){const n=this.covered.get(t);if(n!==void 0)return n;const s=this.host.held(e);if(s===null)return null;const r={payload:s.payload,material:s.material,hash:s.hash},a=gd(r),o={place:e,revision:-1n,base:r,voxels:a,shown:a,predictions:[]};return this.covered.set(t,o),o}put(t,e,n){t.revision=e,t.base=n,t.voxels=gd(n),t.predictions=t.predictions.filter(s=>s.revision===null||s.revision>e)}eachOf(t,e){for(const n of t.layers.keys()){const s=this.covered.get(n);s===void 0||!s.predictions.includes(t)||!e(s)||(s.predictions=s.predictions.filter(r=>r!==t),this.refresh(n,s))}}refresh(t,e){const n=this.compose(t,e);n!==null&&this.host.show(e.place,n)}compose(t,e){const{predictions:n,base:s,voxels:r}=e;n.length===0&&this.covered.delete(t);let a=r;if(n.length>0){a=r.slice();for(const{layers:l}of n)for(const[c,h]of l.get(t))a[c]=h}const o=l1(a,e.shown);return e.shown=a,o?null:n.length===0?s:{payload:Wc({uniform:null,voxels:a}),material:null,hash:null}}}const h1=(1<<27)-1,u1=32768;function d1(i,t){const e=(s,r)=>typeof s=="number"?s:s[r];let n=0;for(let s=0;s<u1;s++){if(e(i,s)===e(t,s))continue;const[r,a,o]=[s&31,s>>5&31,s>>10],l=h=>h===0?-1:0,c=h=>h===31?1:0;for(let h=l(o);h<=c(o);h++)for(let u=l(a);u<=c(a);u++)for(let d=l(r);d<=c(r);d++)n|=1<<(h+1)*9+(u+1)*3+d+1}return n}const xp=0,wp=1,uc=2;function f1(i){const t=i.reduce((s,r)=>Math.max(s,r.id),0),e=new Uint8Array(t+1).fill(uc),n=new Uint16Array(65536);return i.forEach((s,r)=>{e[s.id]=s.phase==="gas"?xp:s.phase==="liquid"?wp:uc,n[s.id]=r}),{kinds:e,places:n}}function Ko(i,t){const e=i[t]??uc;return e===xp?"gas":e===wp?"liquid":"solid"}class vd{values;count=0;constructor(t){this.values=new Float32Array(t)}add(t){this.values[this.count++%this.values.length]=t}percentiles(...t){const e=Math.min(this.count,this.values.length);if(e===0)return null;const n=this.values.slice(0,e).sort();return t.map(s=>n[Math.min(e-1,Math.floor(e*s))])}clear(){this.count=0}}class p1{seconds=new Float64Array(2);second=-1;add(t){this.turn(t),this.seconds[0]++}at(t){this.turn(t);const e=t/1e3%1;return Math.round(this.seconds[0]+this.seconds[1]*(1-e))}turn(t){const e=Math.floor(t/1e3);e!==this.second&&(this.seconds[1]=e===this.second+1?this.seconds[0]:0,this.seconds[0]=0,this.second=e)}}function m1(i,t,e,n,s){const r=Math.hypot(t.x,t.y,t.z);if(!(r>0))return null;const a=[i.x,i.y,i.z],o=[t.x/r,t.y/r,t.z/r],l=a.map(Math.floor),c=o.map(Math.sign),h=o.map(m=>m===0?1/0:Math.abs(1/m)),u=o.map((m,x)=>m===0?1/0:(m>0?l[x]+1-a[x]:a[x]-l[x])*h[x]);let d=0,f=-1;for(;d<=e;){const m=n(l[0],l[1],l[2]);if(m===void 0)return null;if(s(m)){const x=[0,0,0];return f>=0&&(x[f]=-c[f]),{x:l[0],y:l[1],z:l[2],material:m,distance:d,normal:{x:x[0],y:x[1],z:x[2]}}}f=u[0]<u[1]?u[0]<u[2]?0:2:u[1]<u[2]?1:2,d=u[f],u[f]+=h[f],l[f]+=c[f]}return null}const _d=1048575,ma=(i,t,e)=>((t&_d)*1048576+(e&_d))*8+i,g1=(i,t,e,n)=>`${ma(i,t,n)}/${e}`;class v1{held=new Map;get(t,e,n){return this.held.get(ma(t,e,n))}values(){return this.held.values()}add(t){this.held.set(ma(t.lod,t.x,t.z),t),this.eachAround(t,(e,n)=>{t.near[n]=e,e.near[8-n]=t})}delete(t){this.held.delete(ma(t.lod,t.x,t.z)),this.eachAround(t,(e,n)=>{t.near[n]=e.near[8-n]=void 0})}eachAround({lod:t,x:e,z:n},s){for(let r=0;r<9;r++){const a=r===4?void 0:this.get(t,e+r%3-1,n+Math.floor(r/3)-1);a!==void 0&&s(a,r)}}}const Zo=(i,t)=>Math.floor(i/t);function _1(i,t){const e=Math.ceil(t/32),n=[];for(let s=1,r=i;s<=6&&r<e;s++)r=s===6?e:Math.min(i*2**s,e),n.push({lod:s,radius:r});return n}function Sp(i,t,e,n,s){const r=i.limits,a=Zo(i.minY,32),o=Zo(i.maxY-1,32),l=Math.min(Math.max(Math.ceil((o-a)/2),1),r.viewVerticalRadius),c=Math.max(a+l,Math.min(Zo(t.y,32),o-l));return{centre:{x:Math.floor(t.x),y:c*32+16,z:Math.floor(t.z)},direction:e,horizontalRadius:Math.min(n,r.viewHorizontalRadius),verticalRadius:l,rings:_1(Math.min(n,r.viewHorizontalRadius),s),horizon:r.viewHorizon}}function x1(i,t){const e=[];for(const{lod:n,x:s,y:r,z:a,innerX:o,innerZ:l}of new Aa(i,t).boxes){const c={x0:o.first,x1:o.last,z0:l.first,z1:l.last},h=c.x1<c.x0||c.z1<c.z0;e[n]={lod:n,x0:s.first,x1:s.last,z0:a.first,z1:a.last,y0:r.first,y1:r.last,hole:h?null:c}}return e}const Oa=(i,t,e)=>t>=i.x0&&t<=i.x1&&e>=i.z0&&e<=i.z1;function Mp(i,t,e,n){const s=i[t];return s!==void 0&&Oa(s,e,n)&&!(s.hole!==null&&Oa(s.hole,e,n))}function w1(i,t,e,n){const s=i[t];if(s===void 0)return 0;const{hole:r}=s,a=e>s.x0&&e<s.x1&&n>s.z0&&n<s.z1,o=r!==null&&e>=r.x0-1&&e<=r.x1+1&&n>=r.z0-1&&n<=r.z1+1;if(a&&!o)return 511;let l=0;for(let c=0;c<9;c++)Mp(i,t,e+c%3-1,n+Math.floor(c/3)-1)&&(l|=1<<c);return l}function xd(i,t,e,n){const s=i[t];return s!==void 0&&Oa(s,e,n)}function S1(i){const t=(s,r)=>Math.max(0,r-s+1),e=s=>t(s.x0,s.x1)*t(s.z0,s.z1);let n=0;for(const s of i)s!==void 0&&(n+=(e(s)-(s.hole===null?0:e(s.hole)))*t(s.y0,s.y1));return n}class M1{columns=[];x0=1/0;x1=-1/0;z0=1/0;z1=-1/0;places=[];add(t){this.columns.push(t),this.x0=Math.min(this.x0,t.x),this.x1=Math.max(this.x1,t.x),this.z0=Math.min(this.z0,t.z),this.z1=Math.max(this.z1,t.z)}lay(){if(this.columns.length===0)return;const t=this.x1-this.x0+1;this.places=new Array(t*(this.z1-this.z0+1)).fill(void 0);for(const e of this.columns)this.places[(e.z-this.z0)*t+e.x-this.x0]=e}get(t,e){if(!(t<this.x0||t>this.x1||e<this.z0||e>this.z1))return this.places[(e-this.z0)*(this.x1-this.x0+1)+t-this.x0]}}function y1(i,t){const e=i.length-1,n=i[e],s=Array.from(i,()=>new M1);for(const r of t.values()){const{lod:a,x:o,z:l}=r;a<=e&&Oa(n,o>>e-a,l>>e-a)&&s[a].add(r)}for(const r of s)r.lay();return s}function E1(i,t){const e=[],n=i.length-1;if(n<0)return e;const s=y1(i,t),r=(h,u,d)=>s[h].get(u,d)?.ready?!0:h>0&&a(h,u,d),a=(h,u,d)=>r(h-1,2*u,2*d)&&r(h-1,2*u+1,2*d)&&r(h-1,2*u,2*d+1)&&r(h-1,2*u+1,2*d+1),o=(h,u,d)=>{const f=l(h-1,2*u,2*d),m=l(h-1,2*u+1,2*d),x=l(h-1,2*u,2*d+1),g=l(h-1,2*u+1,2*d+1);return f||m||x||g},l=(h,u,d)=>{const f=s[h].get(u,d);return h>0&&xd(i,h-1,2*u,2*d)&&xd(i,h-1,2*u+1,2*d+1)&&a(h,u,d)?o(h,u,d):f?.ready?(e.push(f),!0):h>0&&o(h,u,d)?!0:f?.begun?(e.push(f),!0):!1},c=i[n];for(let h=c.z0;h<=c.z1;h++)for(let u=c.x0;u<=c.x1;u++)l(n,u,h);return e}function b1(i,t,e,n){let s=1/0;for(const r of i){if(r===void 0)continue;const a=32*2**r.lod;for(let o=r.z0;o<=r.z1;o++)for(let l=r.x0;l<=r.x1;l++){if(!Mp(i,r.lod,l,o)||t.get(r.lod,l,o)?.ready)continue;const c=Math.max(l*a-e,e-(l+1)*a,0),h=Math.max(o*a-n,n-(o+1)*a,0);s=Math.min(s,c*c+h*h)}}return s===1/0?null:Math.sqrt(s)}function T1(i,t,e){let n=null,s=null,r=1024,a=!0;for(let l=t.y1;l>=t.y0&&r>0;l--){const c=i.chunks.get(l);if(c===void 0||c.meshedWith<0){a=!1;continue}const h=c.material===null?null:e(c.material);if(!(h==="gas"||h===null&&c.tops===null)){if(n??=new Int16Array(1024).fill(Xn),h==="liquid"||c.liquidTops!==null){s??=new Int16Array(1024).fill(Xn);for(let u=0;u<1024;u++){const d=h==="liquid"?32:c.liquidTops[u];d>0&&n[u]===Xn&&s[u]===Xn&&(s[u]=l*32+d)}}if(h!=="liquid")for(let u=0;u<1024;u++){if(n[u]!==Xn)continue;const d=h==="solid"?32:c.tops[u];d!==0&&(n[u]=l*32+d,r--)}}}if(i.ready=a,n===null&&s===null)return!1;i.heights=n,i.liquids=s;let o=32767;if(n!==null)for(let l=0;l<1024;l++)n[l]<o&&(o=n[l]);return i.lowest=n===null?Xn:o,!0}const A1=120,R1=32;class C1{constructor(t){this.sliceOf=t}chunks=[];isSorted=!1;sortedAt=-1/0;get length(){return this.chunks.length}add(t){t.queued=!0,this.chunks.push(t),this.isSorted=!1}clear(){this.chunks=[]}moved(){this.isSorted=!1}forEachNext(t,e,n){if(this.chunks.length===0)return;!this.isSorted&&t-this.sortedAt>A1&&this.sort(t,e);const s=[];for(;this.chunks.length>0&&s.length<R1;){const r=this.chunks.pop();r.queued=!1,!n(r)&&(r.queued=!0,s.push(r))}for(let r=s.length-1;r>=0;r--)this.chunks.push(s[r])}sort(t,e){this.sortedAt=t;for(const n of this.chunks)n.order=this.distance(n,e);this.chunks.sort((n,s)=>s.order-n.order),this.isSorted=!0}distance(t,e){const n=32*2**t.lod,s=(t.x+.5)*n-e.x,r=(t.y+.5)*n-e.y,a=(t.z+.5)*n-e.z;return t.hurried?Math.hypot(s,a)-1e5:Math.hypot(s,a)+(r>0?r*.25:-r*.5)+(t.meshedWith>=0&&t.meshedSlice===this.sliceOf(t)?200:0)}}const L1=80,P1=40,I1=240,D1=1,N1=4,U1=4;class F1{constructor(t){this.options=t}shape=[];slice=null;columns=new v1;jobs=new Map;queue=new C1(t=>this.sliceOf(t));nextJob=1;coverStale=!0;stale=new Set;toRefresh=null;leaving=new Set;coveredAt=-1/0;coverMs=0;cover=[];version=0;covers=0;coverVersion=0;camera={x:0,y:0,z:0};held=0;payloadBytes=0;heldPerLevel=[0,0,0,0,0,0,0];get(t,e,n){return this.columns.get(t,e,n)}values(){return this.columns.values()}get settled(){return this.queue.length===0&&this.jobs.size===0&&!this.coverStale&&this.stale.size===0}get waiting(){return this.queue.length+this.jobs.size}get drawn(){return this.cover}nearestMissing(t,e){return b1(this.shape,this,t,e)}setShape(t){const e=t.map((n,s)=>n?.y0!==this.shape[s]?.y0||n?.y1!==this.shape[s]?.y1);this.shape=t;for(const n of this.columns.values()){const s=n.around;if(this.placeInShape(n),s===n.around&&!e[n.lod])continue;const r=t[n.lod];for(const a of n.chunks.values())n.wanted&&a.y>=r.y0&&a.y<=r.y1?this.consider(a):this.leave(a.lod,a.x,a.y,a.z)}this.coverStale=!0}setSlice(t){this.slice=t;for(const e of this.columns.values()){const n=this.isCut(e);if(n||e.cut)for(const s of e.chunks.values())this.consider(s);e.cut=n}this.version++}add(t,e,n,s,r,a,o=h1,l=null){let c=this.get(t,e,s);c===void 0&&(c=new Lw(t,e,s),this.columns.add(c),this.placeInShape(c));let h=c.chunks.get(n);const u=h===void 0;h===void 0&&(h=new Cw(c,n),c.chunks.set(n,h));const d=h.left;(u||d)&&(this.held++,this.heldPerLevel[t]++),d&&c.left--,h.left=!1,this.payloadBytes+=(r?.length??0)-(h.payload?.length??0),h.payload=r,h.material=a,h.hash=l,h.arrived=this.options.now(),h.changed=!0,h.hurried=!u&&!d,this.options.meshers.send(h),this.eachNeighbour(h,(f,m)=>{f.left||(h.known|=1<<m,f.known|=1<<26-m,!u&&o>>>m&1&&(f.changed=!0,f.hurried=!d),this.consider(f))}),this.consider(h)}leave(t,e,n,s){const r=this.get(t,e,s)?.chunks.get(n);r===void 0||r.left||(r.left=!0,r.column.left++,this.leaving.add(r.column),this.payloadBytes-=r.payload?.length??0,r.payload=null,r.known=0,this.held--,this.heldPerLevel[t]--,this.options.meshers.drop(r),this.eachNeighbour(r,(a,o)=>{a.known&=~(1<<26-o)}),r.job!==null&&this.cancel(r),r.drawable===null&&r.meshedWith<0&&this.forget(r),this.coverStale=!0)}meshed(t,e){const n=this.jobs.get(t);if(this.jobs.delete(t),n===void 0||n.job?.id!==t)return;const s=n.job;n.job=null;const r=e.quads.length>0?this.options.drawer.add(s.slot,e):null;r===null&&this.options.drawer.freeSlot(s.slot),n.meshedWith<0&&this.options.arrivedToDrawn(this.options.now()-n.arrived),this.replace(n,r,s.known,s.slice),s.slice===null&&(n.tops=e.tops,n.liquidTops=e.liquidTops,this.stale.add(n.column)),this.consider(n)}failed(t){const e=this.jobs.get(t);this.jobs.delete(t),e?.job?.id===t&&(this.options.drawer.freeSlot(e.job.slot),e.job=null)}update(t){const e=this.options.now();if(Math.abs(t.x-this.camera.x)+Math.abs(t.z-this.camera.z)>24&&(this.camera={...t},this.queue.moved()),this.dispatch(),this.toRefresh===null){if(!this.coverStale&&this.stale.size===0||!this.isDue(e))return;this.coveredAt=e,this.toRefresh=this.stale.size}this.refresh(e,this.toRefresh),this.toRefresh===null&&this.recover()}isDue(t){return t-this.coveredAt>Math.min(I1,Math.max(L1,P1*this.coverMs))||this.cover.length===0}loseMeshes(){for(const t of this.cover)t.drawn=!1;this.cover=[];for(const t of this.columns.values()){t.ready=t.begun=!1,this.stale.add(t);for(const e of t.chunks.values())e.drawable!==null&&this.options.drawer.remove(e.drawable),e.drawable=null,e.meshedWith=-1,e.left?this.forget(e):this.consider(e);t.gather()}this.coverStale=!0}clear(){for(const t of[...this.columns.values()])for(const e of t.chunks.values())this.leave(e.lod,e.x,e.y,e.z),this.forget(e);this.queue.clear(),this.stale.clear(),this.toRefresh=null,this.coverStale=!0,this.recover()}placeInShape(t){t.around=w1(this.shape,t.lod,t.x,t.z),t.wanted=(t.around&16)!==0}wantedAround(t){const e=this.shape[t.lod];if(e===void 0)return 0;const n=t.column.around;let s=(n&-17)<<9;return t.y>e.y0&&(s|=n),t.y<e.y1&&(s|=n<<18),s}eachNeighbour(t,e){const{near:n}=t.column;for(let s=0;s<9;s++){const r=n[s];if(r!==void 0)for(let a=-1;a<=1;a++){if(s===4&&a===0)continue;const o=r.chunks.get(t.y+a);o!==void 0&&e(o,(a+1)*9+s)}}}consider(t){if(t.left||t.queued||t.job!==null||(this.wantedAround(t)&~t.known)!==0)return;const n=this.sliceOf(t);if(!(t.meshedWith>=0&&!t.changed&&(t.known&~t.meshedWith)===0&&t.meshedSlice===n)){if(this.isPlain(t)){const r=t.meshedWith<0;this.replace(t,null,t.known,n),t.changed=t.hurried=!1,(r||t.tops!==null)&&(t.tops=null,this.stale.add(t.column));return}this.queue.add(t)}}sliceOf(t){return this.isCut(t.column)?this.slice:null}isCut(t){if(this.slice===null)return!1;const e=32*2**t.lod;return ql(this.slice,(t.x-1/32)*e,(t.z-1/32)*e,e*1.0625)==="cut"}isPlain(t){if(t.material===null)return!1;const e=this.options.kindOf(t.material);if(e==="gas")return!0;if(this.sliceOf(t)!==null)return!1;let n=!0;const s=(r,a,o)=>{const l=(a+1)*9+(o+1)*3+r+1;if(!n||!(t.known>>>l&1))return;const c=t.column.near[(o+1)*3+r+1]?.chunks.get(t.y+a);if(c===void 0||c.material===null){n=!1;return}const h=this.options.kindOf(c.material);h==="solid"||h===e||(n=!1)};return s(-1,0,0),s(1,0,0),s(0,-1,0),s(0,1,0),s(0,0,-1),s(0,0,1),n}replace(t,e,n,s){t.drawable!==null&&this.options.drawer.remove(t.drawable);const r=t.drawable!==null;t.drawable=e,(r||e!==null)&&t.column.gather(),t.meshedWith=n,t.meshedSlice=s;const{column:a}=t;!a.begun&&e!==null&&(a.begun=this.coverStale=!0),a.ready||this.stale.add(a),this.version++}dispatch(){this.queue.forEachNext(this.options.now(),this.camera,t=>{if(t.left||(this.wantedAround(t)&~t.known)!==0)return!0;if(!this.options.meshers.hasRoom(t))return!1;const e=this.sliceOf(t),n=this.options.drawer.takeSlot(t.lod,t.x,t.y,t.z),s=this.nextJob++;return t.job={id:s,known:t.known,slice:e,slot:n},t.changed=t.hurried=!1,this.jobs.set(s,t),this.options.meshers.mesh(t,{id:s,lod:t.lod,x:t.x,y:t.y,z:t.z,slot:n,known:t.known,slice:e}),!0})}cancel(t){this.jobs.delete(t.job.id),this.options.drawer.freeSlot(t.job.slot),t.job=null}forget(t){const{column:e}=t;t.left&&e.left--,e.chunks.delete(t.y),t.drawable!==null&&(this.options.drawer.remove(t.drawable),t.drawable=null,e.gather()),e.chunks.size===0&&(this.columns.delete(e),this.leaving.delete(e),this.stale.delete(e))}refresh(t,e){if(this.stale.size===0){this.toRefresh=null;return}const n=this.cover.length===0?N1:D1;let s=0;for(const r of this.stale){if(s===e||s>=U1&&this.options.now()-t>n)break;s++,this.stale.delete(r);const a=this.shape[r.lod];if(a===void 0)continue;const{ready:o}=r;T1(r,a,this.options.kindOf)&&this.options.heights(r),this.coverStale||=o!==r.ready}this.toRefresh=s<e&&this.stale.size>0?e-s:null,this.version++}recover(){if(!this.coverStale)return;this.coverStale=!1;const t=this.options.now();this.version++,this.drawAnew(),this.coverMs=this.options.now()-t}drawAnew(){const t=this.cover;this.cover=E1(this.shape,this),this.covers++;const e=[];for(const n of this.cover)n.coveredIn=this.covers,n.drawn||e.push(n);for(const n of t)n.coveredIn!==this.covers&&e.push(n);e.length>0&&this.coverVersion++;for(const n of e)n.drawn=n.coveredIn===this.covers;for(const n of e)for(const s of[1,3,4,5,7])n.near[s]?.findSkirts();for(const n of this.leaving)if(n.left===0&&this.leaving.delete(n),!(n.left===0||n.drawn&&(!n.wanted||!n.ready)))for(const s of n.chunks.values())s.left&&this.forget(s)}}class O1{constructor(t,e,n){this.options=t,this.events=e,this.isFull=n}client;hasEnded=!1;isClosed=!1;untaken=[];open(t){const e=new URL(this.options.url);this.options.transport==="websocket"&&(e.protocol=e.protocol==="https:"?"wss:":"ws:");const n=s1({url:e.href,token:t,clientName:"talus-viewer",manualCredit:!0});this.client=n,this.hasEnded=!1;const{events:s}=this,r=()=>n===this.client&&!this.isClosed;n.on("connected",(o,l)=>r()&&s.connected(o,l)),n.on("chunk",o=>{r()&&(s.chunk(o),this.isFull()?this.untaken.push(o):n.taken(o))}),n.on("chunkLeft",o=>r()&&s.left(o)),n.on("viewComplete",()=>r()&&s.viewComplete()),n.on("disconnected",(o,l)=>{r()&&l!==null&&s.lost(o.message,!1)}),n.on("error",o=>r()&&s.error(o.message)),n.on("closed",o=>{r()&&(this.hasEnded=!0,o!==null&&s.lost(o.message,o.kind==="refused"))});const a=n.ready();return a.catch(()=>{}),a}hurry(){return this.hasEnded||this.client.retry(),!this.hasEnded}takeBacklog(){for(;this.untaken.length>0&&!this.isFull();)this.client.taken(this.untaken.shift())}close(){this.isClosed=!0,this.client.close()}drop(){this.client.close()}}const k1=-1,B1=-2;class z1{rows=[];payloads=[];hashes=[];bytes=0;get isEmpty(){return this.rows.length===0}add({lod:t,x:e,y:n,z:s,payload:r,material:a,hash:o}){const l=a===null?r:null;this.rows.push(t,e,n,s,a??k1,l?.length??0),l!==null&&(this.payloads.push(l),this.hashes.push(o),this.bytes+=l.length)}drop({lod:t,x:e,y:n,z:s}){this.rows.push(t,e,n,s,B1,0)}take(){const t=new Uint8Array(this.bytes);let e=0;for(const r of this.payloads)t.set(r,e),e+=r.length;const n=Int32Array.from(this.rows),{hashes:s}=this;return this.hashes=[],this.rows.length=this.payloads.length=this.bytes=0,{table:n,payloads:t,hashes:s}}}const Yr=3,G1=6,H1=i=>Math.min(4,Math.max(2,i-1));class V1{constructor(t,e,n,s){this.handle=n,this.broken=s,this.crews=Array.from({length:t},()=>{const r={worker:e(),jobs:0,changes:new z1,orders:[],heldBytes:0};return r.worker.onmessage=a=>this.answered(r,a.data),r.worker.onerror=({message:a})=>this.broken(a||"it did not start"),r.worker.onmessageerror=()=>this.broken("a message that cannot be read"),r})}crews;ownerOfJob=new Map;meshMs=0;meshes=0;get heldBytes(){return this.crews.reduce((t,e)=>t+e.heldBytes,0)}get meanMs(){return this.meshes===0?0:this.meshMs/this.meshes}setWorld(t,e){for(const n of this.crews)this.post(n,{kind:"world",kinds:t,places:e})}send(t){for(const e of this.holdersOf(t))e.changes.add(t)}drop(t){for(const e of this.holdersOf(t))e.changes.drop(t)}hasRoom(t){return this.ownerOf(t.lod,t.x,t.z).jobs<G1}mesh(t,e){const n=this.ownerOf(t.lod,t.x,t.z);n.jobs++,n.orders.push(e),this.ownerOfJob.set(e.id,n)}flush(){for(const t of this.crews)this.flushCrew(t)}dispose(){for(const t of this.crews)t.worker.terminate()}flushCrew(t){if(t.changes.isEmpty&&t.orders.length===0)return;const e=t.changes.isEmpty?null:t.changes.take(),n=e===null?[]:[e.table.buffer,e.payloads.buffer];this.post(t,{kind:"work",changes:e,jobs:t.orders.splice(0)},n)}post(t,e,n=[]){t.worker.postMessage(e,n)}ownerOf(t,e,n){const s=this.crews.length,r=(e>>Yr)+(n>>Yr)+t;return this.crews[(r%s+s)%s]}holdersOf({lod:t,x:e,z:n}){const s=a=>a+1>>Yr===a-1>>Yr;if(s(e)&&s(n))return[this.ownerOf(t,e,n)];const r=new Set;for(let a=-1;a<=1;a++)for(let o=-1;o<=1;o++)r.add(this.ownerOf(t,e+o,n+a));return r}answered(t,e){this.ownerOfJob.delete(e.id)&&t.jobs--,e.kind==="meshed"&&(this.meshMs+=e.ms,this.meshes++,t.heldBytes=e.heldBytes),this.handle(e)}}const W1=250,X1=Math.PI/6;class q1{chunks="";yaw=0;at=-1/0;get hasSent(){return this.chunks!==""}reset(){this.chunks="",this.at=-1/0}next(t,e,n,s,r,a){if(t-this.at<W1)return null;const{yaw:o,pitch:l}=n,c={x:Math.sin(o)*Math.cos(l),y:Math.sin(l),z:-Math.cos(o)*Math.cos(l)},h=Sp(e,n,c,s,r),{x:u,y:d,z:f}=h.centre,m=S=>Math.floor(S/32),x=JSON.stringify([m(u),m(d),m(f),h.horizontalRadius,h.verticalRadius,h.rings]),g=Math.abs(Math.atan2(Math.sin(o-this.yaw),Math.cos(o-this.yaw)))>X1,p=x!==this.chunks;return!p&&!(g&&!a)?null:(this.chunks=x,this.yaw=o,this.at=t,{view:h,moved:p})}}const $1=128;class Y1{constructor(t){this.chunkAt=t}decoded=new Map;get bytes(){return this.decoded.size*65536}atBlock(t,e,n,s){const r=this.chunkAt(Math.floor(t/32),Math.floor(e/32),Math.floor(n/32));if(r===void 0||r.left)return e>=s?0:void 0;const a=o=>(o%32+32)%32;return this.at(r,a(t),a(e),a(n))}at(t,e,n,s){if(t.material!==null)return t.material;if(t.payload===null)return;const r=g1(t.lod,t.x,t.y,t.z);let a=this.decoded.get(r);if((a===void 0||a.payload!==t.payload)&&(a={payload:t.payload,voxels:K1(t.payload,t.hash)},this.decoded.set(r,a),this.decoded.size>$1&&this.decoded.delete(this.decoded.keys().next().value)),a.voxels!==null)return typeof a.voxels=="number"?a.voxels:a.voxels[sS(e,n,s)]}clear(){this.decoded.clear()}}function K1(i,t){try{return Fa(i,t)}catch{return null}}const Z1=3e3,J1=3e3;class Yc{constructor(t){this.options=t,this.radius=t.radius,this.horizon=t.horizon,this.token=t.token,this.reducedMotion=t.reducedMotion,this.link=new O1(t,{connected:(e,n)=>this.onConnected(e,n),chunk:e=>{const{lod:n,x:s,y:r,z:a}=e.key;this.rate.add(performance.now());const o=n===0?this.predictions.arrived(e.key,e.revision,e):e;o!==null&&this.addChunk(n,s,r,a,o)},left:e=>{e.lod===0&&this.predictions.left(e),this.land.leave(e.lod,e.x,e.y,e.z)},viewComplete:()=>{this.viewComplete=!0,this.workSoon()},lost:(e,n)=>this.setState(n?"refused":"lost",e),error:e=>this.emit("error",e)},()=>this.land.waiting>=Z1),this.joined=this.link.open(this.token),this.pool=new V1(H1(navigator.hardwareConcurrency??2),()=>new Worker(new URL(""+new URL("worker-iEGWM72J.js",import.meta.url).href,import.meta.url),{type:"module"}),e=>{this.disposed||(this.workSoon(),e.kind==="meshed"?this.land.meshed(e.id,e.mesh):(this.land.failed(e.id),e.text!=="not held"&&this.emit("error",`a chunk does not decode: ${e.text}`)))},e=>this.emit("error",`a worker that makes meshes ended: ${e}`));try{this.frames=new lS(t.canvas,t.quality)}catch(e){throw this.link.close(),this.pool.dispose(),new Error(`this browser cannot draw the world: it needs WebGL 2 (${e.message})`)}this.land=new F1({drawer:this.frames.terrain,meshers:this.pool,kindOf:e=>Ko(this.kinds,e),now:()=>performance.now(),heights:e=>{this.frames.ground?.set(e),e.liquids!==null&&this.seaLevel===null&&this.seeSea(e.liquids,e.lod)},arrivedToDrawn:e=>this.latency.add(e)}),this.predictions=new c1({held:({x:e,y:n,z:s})=>{const r=this.land.get(0,e,s)?.chunks.get(n);return r===void 0||r.left?null:r},show:({x:e,y:n,z:s},r)=>this.addChunk(0,e,n,s,r)}),this.editing=new gS(this.predictions,()=>this.disposed?null:this.link.client),t.canvas.addEventListener("webglcontextlost",this.onContextLost),t.canvas.addEventListener("webglcontextrestored",this.onContextRestored)}static async create(t){const e=new Yc(t);try{await e.joined}catch(n){throw e.dispose(),n}return e}info=null;link;joined;frames;pool;land;voxels=new Y1((t,e,n)=>this.land.get(0,t,n)?.chunks.get(e));handlers=new Map;kinds=new Uint8Array;state="connecting";viewComplete=!1;complete=!1;eye={x:0,y:0,z:0,yaw:0,pitch:0};views=new q1;chunksWanted=0;radius;horizon;token;slice=null;selection=null;marker=null;predictions;editing;nearestFirst=new mS;lost=!1;disposed=!1;started=performance.now();hasPicture=!1;firstFrameMs=null;completeMs=null;latency=new vd(1024);cpu=new vd(256);updated=0;rate=new p1;seaLevel=null;drawnVersion=-1;reducedMotion;wantsPicture=[];get world(){if(this.info===null)throw new Error("the engine has not joined yet");return{...this.info,seaLevel:this.seaLevel}}setCamera(t,e,n,s,r){this.eye={x:t,y:e,z:n,yaw:s,pitch:r}}setFov(t){this.frames.setFov(t)}resize(t,e,n){this.frames.resize(t,e,n)}update(){if(this.disposed)return;const t=performance.now();this.sendView(t),this.work(),this.updated+=performance.now()-t}frame(t){if(this.disposed)return;const e=performance.now();!this.lost&&this.info!==null&&this.draw(t),this.cpu.add(performance.now()-e+this.updated),this.updated=0}voxelAt(t,e,n){return this.voxels.atBlock(t,e,n,this.info?.maxY??1/0)}raycast(t,e,n,s=!1){return m1(t,e,n,(r,a,o)=>this.voxelAt(r,a,o),r=>this.isSolid(r)||s&&this.isLiquid(r))}isSolid(t){return Ko(this.kinds,t)==="solid"}isLiquid(t){return Ko(this.kinds,t)==="liquid"}setTimeOfDay(t){this.frames.setTimeOfDay((t%24+24)%24)}setSlice(t){const e=this.slice?.x===t?.x&&this.slice?.z===t?.z&&this.slice?.yaw===t?.yaw;this.slice=t,!e&&this.land.setSlice(t===null?null:{x:t.x,z:t.z,nx:Math.sin(t.yaw),nz:-Math.cos(t.yaw)})}setChunkBorders(t){this.frames.setBorders(t)}setSelection(t){this.selection=t}setMarker(t){this.marker=t}get whyNoEdits(){return this.options.transport==="http"?"By HTTP one only looks. The settings have WebSocket, which takes edits.":this.info===null?"The world is not here yet.":/^0*$/.test(this.info.storeId)?"This server keeps no edits: it has no place to store them.":null}editLimits(){return this.link.client.editLimits()}edit(t,e){return this.editing.edit(this.link.client,t,e)}setRadius(t,e){t===this.radius&&e===this.horizon||(this.radius=t,this.horizon=e,this.info!==null&&this.makeGround())}setQuality(t){this.frames.setQuality(t)}setReducedMotion(t){this.reducedMotion=t}setToken(t){this.token=t,this.reconnect()}hurry(){this.link.hurry()||this.reconnect()}reconnect(){this.link.drop(),this.setState("connecting",""),this.joined=this.link.open(this.token)}screenshot(){return new Promise((t,e)=>{this.wantsPicture.push(n=>n?t(n):e(new Error("the browser made no picture")))})}stats(){const t=performance.now(),{latency:e,cpu:n,land:s,eye:r}=this;return{state:this.state,chunks:this.land.held,chunksPerLevel:[...this.land.heldPerLevel],chunksWanted:this.chunksWanted,pendingMeshes:this.land.waiting,meshes:this.frames.terrain.meshes,current:this.land.version===this.drawnVersion,triangles:this.frames.triangles,drawCalls:this.frames.drawCalls,receivedBytes:this.link.client.stats.receivedBytes,get latency(){const a=e.percentiles(.5,.95,.99);return a&&{p50:a[0],p95:a[1],p99:a[2]}},chunkRate:this.rate.at(t),get nearestMissing(){return s.nearestMissing(r.x,r.z)},gpuBytes:this.frames.gpuBytes,heapBytes:this.pool.heldBytes+this.voxels.bytes+this.land.payloadBytes,get frameCpu(){const[a,o]=n.percentiles(.5,.95)??[0,0];return{p50:a,p95:o}},meshMs:this.pool.meanMs,hasPicture:this.hasPicture,firstFrameMs:this.firstFrameMs,completeMs:this.completeMs}}on(t,e){let n=this.handlers.get(t);return n===void 0&&this.handlers.set(t,n=new Set),n.add(e),()=>void n.delete(e)}dispose(){this.disposed||(this.disposed=!0,this.options.canvas.removeEventListener("webglcontextlost",this.onContextLost),this.options.canvas.removeEventListener("webglcontextrestored",this.onContextRestored),this.link.close(),this.pool.dispose(),this.frames.dispose())}onConnected(t,e){const n=this.info===null||!e||this.info.fingerprint!==t.fingerprint;n&&(this.info!==null&&(this.land.clear(),this.predictions.clear(),this.voxels.clear()),this.info={...t,seaLevel:null},this.seaLevel=null,this.prepareMaterials(t),this.makeGround(),!this.views.hasSent&&this.eye.x===0&&this.eye.z===0&&(this.eye={...this.eye,x:t.spawn.x+.5,y:t.spawn.y+1.6,z:t.spawn.z+.5})),this.setState("streaming",""),this.views.hasSent&&(this.views.reset(),this.sendView(performance.now())),this.emit("world",this.world,!n)}addChunk(t,e,n,s,{payload:r,material:a,hash:o}){const l=this.land.get(t,e,s)?.chunks.get(n),c=l!==void 0&&!l.left&&l.meshedWith>=0;let h;if(c)try{h=d1(l.material??Fa(l.payload),a??Fa(r))}catch{}this.land.add(t,e,n,s,r,a,h,o),this.workSoon()}prepareMaterials(t){const e=t.materials.slice(0,Zw),{kinds:n,places:s}=f1(e);this.kinds=n,this.pool.setWorld(n,s),this.frames.setMaterials(dS(e))}makeGround(){const t=Sp(this.info,this.eye,{x:0,y:0,z:0},this.radius,this.horizon).rings.length+1,e=Math.round((this.info.minY+this.info.maxY)/128)*64;this.groundBase=this.info.maxY-this.info.minY<2e3?0:e;const n=this.frames.ground;if(!(n!==null&&n.isFor(this.radius,t,this.groundBase)&&!this.lost)){this.frames.setGround(new kw(this.frames.renderer,this.radius,t,this.groundBase));for(const s of this.land.values())(s.heights!==null||s.liquids!==null)&&this.frames.ground.set(s)}}groundBase=0;seeSea(t,e){for(const n of t)if(!(n<=-32768)){this.seaLevel=n*2**e;return}}sendView(t){const e=this.info&&this.views.next(t,this.info,this.eye,this.radius,this.horizon,this.complete);if(e===null)return;const{view:n,moved:s}=e;try{this.link.client.setView(n)}catch(c){this.emit("error",c.message);return}if(!s)return;const r=x1(n,this.info);this.land.setShape(r),this.chunksWanted=S1(r),this.viewComplete=this.complete=!1,this.state==="complete"&&this.setState("streaming","");const a=c=>Math.floor(c/32)*32+16,{x:o,z:l}=n.centre;this.frames.setReach(a(o),a(l),n.horizontalRadius*32,this.reach(n))}work(){this.link.takeBacklog(),this.land.update(this.eye),this.pool.flush(),this.settle(performance.now())}workSoon(){this.working||(this.working=!0,setTimeout(()=>{this.working=!1,this.disposed||this.work()},6))}working=!1;settle(t){!this.viewComplete||this.complete||!this.land.settled||(this.complete=!0,this.completeMs??=t-this.started,this.state==="streaming"&&this.setState("complete",""))}draw(t){const{eye:e}=this;this.land.version!==this.drawnVersion&&this.frames.landChanged();const n=this.options.frozenTime??(this.reducedMotion?0:null),s=bw(c=>{const h=this.voxelAt(Math.floor(e.x),Math.floor(c),Math.floor(e.z));return h!==void 0&&this.isLiquid(h)},e.y),r=this.land.get(0,Math.floor(e.x/32),Math.floor(e.z/32)),a=c=>(Math.floor(c)%32+32)%32,o=r?.heights?.[a(e.z)*32+a(e.x)]??-32768;if(this.frames.draw({eye:e,columns:this.nearestFirst.update(this.land.drawn,this.land.coverVersion,e.x,e.z),seconds:n??t/1e3,now:performance.now(),slice:this.land.slice,selected:this.selection,marker:this.marker,seaLevel:this.seaLevel,underWater:s.under,closeToWater:s.close,hideBuried:this.land.slice===null&&e.y>o-4,groundBase:this.groundBase,onlyWithLand:!this.hasPicture&&!this.complete&&performance.now()-this.started<J1})){this.hasPicture=!0,this.drawnVersion=this.land.version,this.firstFrameMs===null&&this.frames.triangles>1&&(this.firstFrameMs=performance.now()-this.started);for(const c of this.wantsPicture.splice(0))this.options.canvas.toBlob(c,"image/png")}}reach(t){const e=32*(t.rings?.at(-1)?.radius??t.horizontalRadius);return this.horizon===0?e:Math.min(this.horizon,e)}setState(t,e){t===this.state&&e===""||(this.state=t,this.emit("state",t,e))}emit(t,...e){for(const n of this.handlers.get(t)??[])n(...e)}onContextLost=t=>{t.preventDefault(),this.lost=!0,this.emit("contextLost")};onContextRestored=()=>{this.frames.contextRestored(),this.land.loseMeshes(),this.info!==null&&this.makeGround(),this.lost=!1,this.complete=!1,this.state==="complete"&&this.setState("streaming",""),this.emit("contextRestored")}}const Q1=500,j1=15e3,wd=2e3,tE=6e3,Sd=i=>/token|unauthori[sz]ed/i.test(i);class eE{constructor(t,e,n,s,r,a){this.stage=t,this.settings=e,this.server=n,this.tokens=s,this.isReduced=r,this.listener=a,addEventListener("online",()=>this.hurry()),document.addEventListener("visibilitychange",()=>{document.visibilityState==="visible"&&this.hurry()})}engine=null;began=0;#t=0;#e=0;#n=0;#i;#s;#r=null;#o=!1;async open(){this.#l(),this.#n=0;const t=++this.#t,e=await this.server.obstacle();if(t!==this.#t)return;if(e!==null)return this.#f(e);const n=document.createElement("canvas");n.id="view",this.stage.querySelector("canvas")?.remove(),this.stage.prepend(n);const{token:s}=this.tokens;let r;this.#s=setTimeout(()=>void this.#h(t),wd),this.began=performance.now();try{r=await Yc.create({canvas:n,url:this.server.base.replace(/\/$/,""),transport:this.settings.transport,...s===null?{}:{token:s},radius:this.settings.radius,horizon:this.settings.horizon,quality:this.settings.quality,reducedMotion:this.isReduced()})}catch(a){t===this.#t&&await this.#d(t,a instanceof Error?a.message:String(a));return}if(t!==this.#t){r.dispose();return}clearTimeout(this.#s),this.#e=0,this.#a(r)}hurry(){this.#i!==void 0?this.open():this.engine?.stats().state==="lost"&&this.engine.hurry()}again(){if(this.engine===null)return void this.open();const{token:t}=this.tokens;t!==null&&this.engine.setToken(t),this.engine.reconnect()}#a(t){this.engine=t,t.on("state",(e,n)=>{e==="lost"?this.#c({kind:"away",text:n,retryAt:null}):e==="refused"?this.#c(Sd(n)?{kind:"token",text:n}:{kind:"refused",text:n}):e!=="connecting"&&this.#c(null)}),t.on("world",e=>this.#u(e)),t.on("contextLost",()=>{this.#c({kind:"graphics-lost"}),this.#s=setTimeout(()=>void this.open(),tE)}),t.on("contextRestored",()=>{clearTimeout(this.#s),this.#c(null)}),this.listener.opened(t,this.#o),this.#o=!0,this.#c(null),this.#u(t.world)}#u(t){const e=this.#r!==null&&this.#r!==t.fingerprint;this.#r=t.fingerprint,e&&this.listener.worldChanged(t)}async#h(t){const e=await this.server.obstacle();t!==this.#t||this.engine!==null||(e?.kind==="away"?this.#c({kind:"away",text:e.text,retryAt:null}):this.settings.transport==="websocket"&&++this.#n>1&&this.#c({kind:"no-socket",text:"The server answers, but its WebSocket does not open."}),this.#s=setTimeout(()=>void this.#h(t),wd))}async#d(t,e){if(clearTimeout(this.#s),document.createElement("canvas").getContext("webgl2")===null)return this.#c({kind:"no-webgl",text:e});const n=await this.server.obstacle();t===this.#t&&this.#f(n??{kind:Sd(e)?"token":"away",text:e})}#f({kind:t,text:e}){if(t==="token")return this.#c({kind:t,text:e});if(t!=="away")return this.#c({kind:"refused",text:e});const n=Math.min(j1,Q1*2**this.#e++);this.#i=setTimeout(()=>void this.open(),n),this.#c({kind:t,text:e,retryAt:performance.now()+n})}#c(t){this.listener.trouble(t)}#l(){clearTimeout(this.#i),clearTimeout(this.#s),this.#i=void 0,this.engine!==null&&(this.listener.closing(),this.engine.dispose(),this.engine=null)}}const Md={KeyW:["forward",1],KeyS:["forward",-1],KeyD:["right",1],KeyA:["right",-1],Space:["up",1],KeyC:["up",-1],ArrowUp:["forward",1],ArrowDown:["forward",-1],ArrowRight:["turn",1],ArrowLeft:["turn",-1],KeyE:["turn",1],KeyQ:["turn",-1],PageUp:["tilt",1],PageDown:["tilt",-1]};function nE(i,t){return i instanceof HTMLElement?i.isContentEditable||/^(INPUT|SELECT|TEXTAREA)$/.test(i.tagName)?t!=="Escape":/^(BUTTON|A|SUMMARY)$/.test(i.tagName)&&(t==="Space"||t==="Enter"):!1}class iE{#t=new Set;constructor(t,e){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.altKey||n.metaKey||nE(n.target,n.code))&&!e()){if(n.code in Md)this.#t.add(n.code),n.preventDefault();else if(n.key==="Shift")this.#t.add("Shift");else if(!n.repeat){const s=t[n.code]??t[n.key];if(s===void 0)return;n.preventDefault(),s()}}}),addEventListener("keyup",n=>this.#t.delete(n.key==="Shift"?"Shift":n.code))}read(t){for(const e of this.#t){const n=Md[e];n!==void 0&&(t[n[0]]+=n[1])}for(const e of["forward","right","up","turn","tilt"])t[e]=Math.max(-1,Math.min(1,t[e]));this.#t.has("Shift")&&(t.fast=!0)}release(){this.#t.clear()}}const sE=4;class rE{constructor(t,e,n,s,r){this.canvas=t,this.settings=e,t.addEventListener("pointerdown",a=>{if(a.pointerType!=="mouse")return;const o=a.button===2&&r();a.button!==0&&!o||(this.isLocked?n(t.clientWidth/2,t.clientHeight/2,o):o?n(a.clientX,a.clientY,!0):this.#n={x:a.clientX,y:a.clientY,moved:!1})}),addEventListener("pointermove",a=>{a.pointerType==="mouse"&&(!this.isLocked&&this.#n===null||this.#n!==null&&(Math.hypot(a.clientX-this.#n.x,a.clientY-this.#n.y)>sE&&(this.#n.moved=!0),!this.#n.moved)||this.#i(a.movementX,a.movementY))}),addEventListener("pointerup",a=>{if(a.pointerType!=="mouse"||this.#n===null)return;const o=!this.#n.moved;if(this.#n=null,!o)return;const l=()=>n(a.clientX,a.clientY,!1);if(r())return this.#s(l);l(),this.#s()}),t.addEventListener("contextmenu",a=>{r()&&a.preventDefault()}),t.addEventListener("wheel",a=>{a.preventDefault(),s(-Math.sign(a.deltaY||a.deltaX),a.shiftKey)},{passive:!1})}#t=0;#e=0;#n=null;get isLocked(){return document.pointerLockElement===this.canvas}read(t){t.yaw+=this.#t,t.pitch+=this.#e,this.#t=this.#e=0}release(){this.#n=null,this.#t=this.#e=0}#i(t,e){const n=this.settings.sensitivity;this.#t+=t*n,this.#e-=e*n*(this.settings.invertLook?-1:1)}#s(t=()=>{}){this.canvas.requestPointerLock()?.catch(t)}}const yp=1e-4,Di=i=>Math.floor(i+yp),Ni=i=>Math.ceil(i-yp)-1;function yd(i,t){for(let e=Di(i.low[1]);e<=Ni(i.high[1]);++e)for(let n=Di(i.low[2]);n<=Ni(i.high[2]);++n)for(let s=Di(i.low[0]);s<=Ni(i.high[0]);++s)if(t(s,e,n))return!0;return!1}function aE(i,t,e,n){if(e===0)return 0;const[s,r]=t===0?[1,2]:t===1?[0,2]:[0,1],a=[0,0,0],o=l=>{for(a[t]=l,a[s]=Di(i.low[s]);a[s]<=Ni(i.high[s]);++a[s])for(a[r]=Di(i.low[r]);a[r]<=Ni(i.high[r]);++a[r])if(n(a[0],a[1],a[2]))return!0;return!1};if(e>0){const l=i.high[t];for(let c=Ni(l)+1;c<=Ni(l+e);++c)if(o(c))return Math.max(0,c-l)}else{const l=i.low[t];for(let c=Di(l)-1;c>=Di(l+e);--c)if(o(c))return Math.min(0,c+1-l)}return e}const Kr=.3,oE=1.8,Ed=1.62,lE=5,cE=9,bd=3.2,hE=27,Td=8.6,uE=1.02,dE=120,fE=80,pE=1/60,dc={slowest:2,usual:24,fastest:600},Os=Math.PI/180,Zr=(i,t,e)=>i+(t-i)*e;class mE{constructor(t){this.stuffAt=t}position=[0,0,0];velocity=[0,0,0];yaw=0;pitch=0;mode="fly";flySpeed=dc.usual;onGround=!1;swimming=!1;waiting=!1;#t=0;get eye(){return[this.position[0],this.position[1]+Ed-this.#t,this.position[2]]}place(t,e,n){this.position[0]=t,this.position[1]=e,this.position[2]=n,this.velocity.fill(0),this.#t=0}step(t,e){if(this.yaw=((this.yaw+e.yaw+e.turn*dE*t)%360+360)%360,this.pitch=Math.min(89.9,Math.max(-89.9,this.pitch+e.pitch+e.tilt*fE*t)),this.mode==="fly")return this.#n(t,e);const n=Math.max(1,Math.ceil(t/pE));for(let s=0;s<n;++s)this.#i(t/n,e)}isIn(t,e){const{low:n,high:s}=this.#u(),r=(a,o,l)=>o<s[a]&&n[a]<l+1;return r(0,t.x,e.x)&&r(1,t.y,e.y)&&r(2,t.z,e.z)}get isBuried(){const[t,e,n]=this.eye;return this.#d("unknown",t,e,n)?void 0:this.#d("solid",t,e,n)}get speed(){return Math.hypot(...this.velocity)}rise(t){const e=this.position[1];for(let n=0;n<=t;++n)if(this.position[1]=n===0?e:Math.floor(e)+n,!yd(this.#u(),this.#h))return!0;return this.position[1]=e,!1}#e(t){const[e,n]=[Math.sin(this.yaw*Os),Math.cos(this.yaw*Os)],s=e*t.forward+n*t.right,r=-n*t.forward+e*t.right,a=Math.max(1,Math.hypot(s,r));return{x:s/a,z:r/a}}#n(t,e){const n=this.flySpeed*(e.fast?4:1),s=Math.cos(this.pitch*Os),r=this.#e({...e,forward:e.forward*s}),a=Math.sin(this.pitch*Os)*e.forward+e.up,o=[r.x*n,Math.max(-1,Math.min(1,a))*n,r.z*n],l=1-Math.exp(-t*9);for(const c of[0,1,2]){const h=Zr(this.velocity[c],o[c],l);this.velocity[c]=Math.abs(h)<.001?0:h,this.position[c]+=this.velocity[c]*t}this.onGround=this.swimming=this.waiting=!1,this.#t=0}#i(t,e){if(this.#t*=Math.exp(-t*14),this.waiting=this.#f(),this.waiting){this.velocity.fill(0);return}if(yd(this.#u(),this.#h)&&!this.rise(64)){this.velocity.fill(0);return}const[n,s,r]=this.position;this.swimming=this.#d("liquid",n,s+.9,r);const a=this.swimming||this.#d("liquid",n,s+.3,r),o=this.#e(e),l=this.swimming?bd*(e.fast?1.6:1):e.fast?cE:lE,c=1-Math.exp(-t*(this.swimming?5:this.onGround?16:4));this.velocity[0]=Zr(this.velocity[0],o.x*l,c),this.velocity[2]=Zr(this.velocity[2],o.z*l,c),this.swimming?this.#s(t,e):(this.velocity[1]=Math.max(-55,this.velocity[1]-hE*t),e.up>0&&this.onGround?this.velocity[1]=Td:e.up>0&&a&&this.velocity[1]<3&&(this.velocity[1]=3)),this.#r(t,a,e)}#s(t,e){const n=e.forward>0?Math.sin(this.pitch*Os)*e.forward:0,r=Math.max(-1,Math.min(1,e.up+n))*bd+(e.up===0?-.6:0);this.velocity[1]=Zr(this.velocity[1],r,1-Math.exp(-t*5))}#r(t,e,n){const s=this.velocity[1]*t,r=this.#a(1,s),a=this.onGround;this.onGround=s<0&&r>s,r!==s&&(this.velocity[1]=0);for(const o of[0,2]){const l=this.velocity[o]*t,c=this.#a(o,l);c!==l&&((this.onGround||a)&&this.#o(o,l-c)||(this.velocity[o]=0,e&&n.up>0&&(this.velocity[1]=Td)))}}#o(t,e){const n=[...this.position],s=this.#a(1,uE),r=this.#a(t,e);this.#a(1,-s);const a=this.position[1]-n[1];if(Math.abs(r)<Math.abs(e)*.5||a<.01||this.#f()){for(const o of[0,1,2])this.position[o]=n[o];return!1}return this.#t+=a,this.onGround=!0,this.velocity[1]<0&&(this.velocity[1]=0),!0}#a(t,e){const n=aE(this.#u(),t,e,this.#h);return this.position[t]+=n,n}#u(){const[t,e,n]=this.position;return{low:[t-Kr,e,n-Kr],high:[t+Kr,e+oE,n+Kr]}}#h=(t,e,n)=>{const s=this.stuffAt(t,e,n);return s==="solid"||s==="unknown"};#d(t,e,n,s){return this.stuffAt(Math.floor(e),Math.floor(n),Math.floor(s))===t}#f(){const[t,e,n]=this.position;return this.#d("unknown",t,e,n)||this.#d("unknown",t,e+Ed,n)||this.#d("unknown",t,e-.5,n)}}const gE=()=>({forward:0,right:0,up:0,turn:0,tilt:0,yaw:0,pitch:0,fast:!1}),Ad=Math.PI/180;class vE{body=new mE((t,e,n)=>this.stuffAt(t,e,n));#t=[];#e=null;hasMoved=!1;add(t){this.#t.push(t)}enter(t){this.#e=t}step(t){const e=gE();for(const n of this.#t)n.read(e);this.hasMoved||=e.forward!==0||e.right!==0||e.up!==0||e.turn!==0||e.tilt!==0||e.yaw!==0,this.body.step(t,e)}release(){for(const t of this.#t)t.release()}look(t){const[e,n,s]=this.body.eye;t.setCamera(e,n,s,this.body.yaw*Ad,this.body.pitch*Ad)}toggleMode(){const{body:t}=this;t.mode=t.mode==="walk"?"fly":"walk",t.velocity.fill(0)}changeSpeed(t){const e=this.body.flySpeed*1.25**t;this.body.flySpeed=Math.min(dc.fastest,Math.max(dc.slowest,e))}stuffAt(t,e,n){const s=this.#e;if(s===null)return"unknown";const r=s.voxelAt(t,e,n);return r===void 0?e<s.world.minY?"solid":"unknown":s.isSolid(r)?"solid":s.isLiquid(r)?"liquid":"gas"}}const Jo=56,_E=250,Qo=8,xE=2;class wE{constructor(t,e,n,s,r){this.canvas=t,this.stick=e,this.settings=n,this.onPick=s,this.onFirst=r,t.addEventListener("pointerdown",a=>this.#s(a)),t.addEventListener("pointermove",a=>this.#r(a)),t.addEventListener("pointerup",a=>this.#o(a,!0)),t.addEventListener("pointercancel",a=>this.#o(a,!1))}#t=new Map;#e=0;#n=0;up=0;hold(t,e){const n=s=>r=>{r.preventDefault(),this.up=s};t.addEventListener("pointerdown",n(e));for(const s of["pointerup","pointercancel","pointerleave"])t.addEventListener(s,n(0))}read(t){const e=this.#i();if(e!==void 0){const[n,s]=[e.atX-e.x,e.atY-e.y],r=Math.hypot(n,s),a=Math.min(1,Math.max(0,r-Qo)/(Jo-Qo));a>0&&(t.right+=n/r*a,t.forward-=s/r*a,r>Jo*1.6&&(t.fast=!0))}t.up+=this.up,t.yaw+=this.#e,t.pitch+=this.#n,this.#e=this.#n=0}release(){this.#t.clear(),this.up=this.#e=this.#n=0,this.#a()}#i(){return[...this.#t.values()].find(t=>t.moves)}#s(t){if(t.pointerType==="mouse")return;this.onFirst(),this.canvas.setPointerCapture(t.pointerId);const e=t.clientX<innerWidth/2&&this.#i()===void 0,{clientX:n,clientY:s,timeStamp:r}=t;this.#t.set(t.pointerId,{x:n,y:s,began:r,moves:e,atX:n,atY:s,strayed:!1}),this.#a()}#r(t){const e=this.#t.get(t.pointerId);if(e!==void 0){if(!e.moves){const n=this.settings.sensitivity*xE;this.#e+=(t.clientX-e.atX)*n,this.#n-=(t.clientY-e.atY)*n*(this.settings.invertLook?-1:1)}e.atX=t.clientX,e.atY=t.clientY,Math.hypot(e.atX-e.x,e.atY-e.y)>Qo&&(e.strayed=!0),this.#a()}}#o(t,e){const n=this.#t.get(t.pointerId);this.#t.delete(t.pointerId)&&(e&&n!==void 0&&!n.strayed&&t.timeStamp-n.began<_E&&this.onPick(n.x,n.y),this.#a())}#a(){const t=this.#i();if(this.stick.hidden=t===void 0,t===void 0)return;const[e,n]=[t.atX-t.x,t.atY-t.y],s=Math.max(1,Math.hypot(e,n)/Jo);this.stick.style.transform=`translate(${t.x}px, ${t.y}px)`,this.stick.firstElementChild.style.transform=`translate(${e/s}px, ${n/s}px)`}}const SE=200,ME=64,yE=256;class EE{#t=[];get isEmpty(){return this.#t.length===0}push(t){const e={made:t};return this.#t.push(e),this.#t.length>SE&&this.#t.shift(),e}remove(t){this.#t=this.#t.filter(e=>e!==t)}pop(){return this.#t.pop()}clear(){this.#t=[]}}function bE(i,t){const e=t>0?Math.floor(t/2):1/0;return Math.max(1,Math.min(Math.floor((i-yE)/ME),e))}function TE(i,t){const e=[];for(let n=0;n<i.length;n+=t){const s=i.slice(n,n+t),r={guards:s.map(({voxel:a,after:o})=>({voxel:a,material:o})),writes:s.map(({voxel:a,before:o})=>({voxel:a,material:o}))};e.push({edit:r,made:s})}return e}const Tn=0,Rd=4096,Ep=({x:i,y:t,z:e})=>({x:i,y:t,z:e});function AE({x:i,y:t,z:e,normal:n}){return n.x===0&&n.y===0&&n.z===0?null:{x:i+n.x,y:t+n.y,z:e+n.z}}function jo(i,t,e){return t==="dig"||e===Tn?Ep(i):AE(i)}function tl(i,t){const e=n=>({x:n(i.x,t.x),y:n(i.y,t.y),z:n(i.z,t.z)});return{first:e(Math.min),last:e(Math.max)}}function bp({first:i,last:t}){return[t.x-i.x+1,t.y-i.y+1,t.z-i.z+1]}function Cd(i){return bp(i).reduce((t,e)=>t*e,1)}function RE({first:i,last:t},e){for(let n=i.y;n<=t.y;++n)for(let s=i.z;s<=t.z;++s)for(let r=i.x;r<=t.x;++r)e({x:r,y:n,z:s})}const el=40,CE=12,Ld=256,Pd=16751978,Id=16733512,LE=({x:i,y:t,z:e})=>`${i}, ${t}, ${e}`,fc=i=>i.charAt(0).toUpperCase()+i.slice(1)+(/[.!?]$/.test(i)?"":"."),PE=i=>/no right to edit/.test(i)?"This server lets only invited players build.":fc(`You may look, but not dig and build here: ${i}`);class IE{constructor(t,e){this.body=t,this.listener=e}isOn=!1;tool="dig";material=Tn;palette=[];waiting=0;#t=null;#e=null;#n=null;#i=null;#s="";#r=new EE;enter(t){if(this.#t=t,this.#r.clear(),this.waiting=0,this.isOn&&this.#a(),t===null)return;const e=({id:n,phase:s})=>n===Tn?0:s==="solid"?1:2;this.palette=t.world.materials.filter(({id:n,phase:s})=>n===Tn||s!=="gas").sort((n,s)=>e(n)-e(s)||n.id-s.id),(!this.palette.some(({id:n})=>n===this.material)||this.material===Tn)&&(this.material=this.palette[1]?.id??Tn),this.ask()}get whyNot(){return this.#o??this.#n}get#o(){return this.#t===null?"The world is not here yet.":this.#t.whyNoEdits}async ask(){const t=this.#t;this.#n=null;let e=this.#o;if(t!==null&&e===null)try{const n=await t.editLimits();t===this.#t&&(this.#e=n)}catch(n){const{kind:s,message:r}=n;e=s==="refused"?PE(r.replace(/^the server says: /,"")):fc(r),t===this.#t&&s==="refused"&&(this.#n=e)}return t===this.#t&&this.listener.changed(),e}async toggle(){if(this.isOn)return this.#a();const t=this.#t,e=await this.ask();if(!(t!==this.#t||this.isOn)){if(e!==null)return this.#l(e,!0);this.isOn=!0,this.listener.changed()}}#a(){this.isOn=!1,this.#i=null,this.#t?.setMarker(null),this.listener.changed()}cancel(){const t=this.#i!==null;return this.#i=null,t}choose(t){this.tool=t,this.#i=null,this.listener.changed()}nextTool(){const t=["dig","build","fill"];this.choose(t[(t.indexOf(this.tool)+1)%t.length])}chooseMaterial(t){this.palette.some(e=>e.id===t)&&(this.material=t,this.tool==="dig"&&t!==Tn&&(this.tool="build"),this.listener.changed())}chooseSwatch(t){const e=this.palette[t];e!==void 0&&this.chooseMaterial(e.id)}turn(t){const{length:e}=this.palette,n=this.palette.findIndex(({id:s})=>s===this.material);e>0&&this.chooseSwatch(((n+t)%e+e)%e)}sample(t,e){const n=this.#t?.raycast(t,e,el,!0);n&&this.chooseMaterial(n.material)}look(t,e){if(!this.isOn||this.#t===null)return;const n=this.#t.raycast(t,e,el),s=n&&jo(n,this.tool,this.material);this.#t.setMarker(s===null?null:this.#u(s))}#u(t){const e=this.tool==="dig"||this.material===Tn,n=tl(this.tool==="fill"?this.#i??t:t,t),s=Cd(n)<=this.#h&&(e||!this.body.isIn(n.first,n.last)),r=e?Pd:this.palette.find(({id:a})=>a===this.material)?.colour??16777215;return s?{...n,colour:r,edge:e?Pd:16777215,veil:e?.14:.55}:{...n,colour:Id,edge:Id,veil:.3}}get#h(){const{voxels:t=0}=this.#e??{};return t>0?Math.min(t,Rd):Rd}act(t,e,n=!1){const s=this.#t;if(!this.isOn||s===null)return;if(this.body.speed>CE)return this.#l("Slow down to dig and build.",!0);if(this.waiting>=Ld)return this.#l("Much waits for the server already.",!0);const r=s.raycast(t,e,el);if(r===null)return this.#l("Nothing is near enough there.",!1);const a=n?this.tool==="dig"?"build":"dig":this.tool;if(a==="fill")return this.#d(s,r);const o=jo(r,a,this.material);o!==null&&this.#f(s,tl(o,o),a==="dig"?Tn:this.material)}#d(t,e){const n=jo(e,"fill",this.material);if(n===null)return;if(this.#i===null)return this.#i=Ep(n),this.#l(`From ${LE(n)}: now the other corner.`,!1);const s=tl(this.#i,n);if(Cd(s)>this.#h)return this.#l(`${bp(s).join(" × ")} voxels are too many: at most ${this.#h} at once.`,!0);this.#f(t,s,this.material)&&(this.#i=null)}#f(t,e,n){if(n!==Tn&&this.body.isIn(e.first,e.last))return this.#l("You stand there yourself.",!0),!1;const s=[];let r=!0;if(RE(e,l=>{const c=t.voxelAt(l.x,l.y,l.z);c===void 0?r=!1:c!==n&&s.push({voxel:l,before:c,after:n})}),!r)return this.#l("The land there is not here yet.",!0),!1;if(s.length===0)return!0;const a=this.#r.push(s),o=s.length===1?{guards:s.map(({voxel:l,before:c})=>({voxel:l,material:c})),writes:[{voxel:s[0].voxel,material:n}]}:{fills:[{...e,material:n}]};return this.#c(t,o,s.map(({voxel:l})=>({...l,material:n})),(l,c)=>{this.#r.remove(a),this.listener.changed(),this.#l(l==="conflict"?"Somebody changed that before you: it is as they left it.":c,!0)}),this.listener.changed(),!0}undo(){const t=this.#t;if(!this.isOn||t===null||this.waiting>=Ld)return;const e=this.#r.pop();if(this.listener.changed(),e===void 0)return this.#l("Nothing of yours is left to undo.",!1);const n=e.made.filter(({voxel:a,after:o})=>t.voxelAt(a.x,a.y,a.z)===o),s=e.made.length-n.length;if(n.length===0)return this.#l("Not undone: somebody has changed it since.",!0);if(n.some(({voxel:a,before:o})=>t.isSolid(o)&&this.body.isIn(a,a)))return this.#r.push(e.made),this.#l("You stand where it would come back: step aside.",!0);s>0&&this.#l(`Undone but for ${s} ${s===1?"voxel":"voxels"} that somebody has changed since.`,!0);const r=bE(t.world.limits.frameBytes,this.#e?.voxels??0);for(const{edit:a,made:o}of TE(n,r)){const l=o.map(({voxel:c,before:h})=>({...c,material:h}));this.#c(t,a,l,(c,h)=>{this.#l(c==="conflict"?"Not undone: somebody has changed it since.":h,!0)})}}get canUndo(){return!this.#r.isEmpty}#c(t,e,n,s){++this.waiting,t.edit(e,n).catch(r=>{t===this.#t&&(s(r.kind,fc(r.message.replace(/^the server says: /,""))),r.kind==="refused"&&this.ask().then(a=>a!==null&&t===this.#t&&this.isOn&&this.#a()))}).finally(()=>{t===this.#t&&--this.waiting})}#l(t,e){this.#s=t,this.listener.say(t,e)}get said(){return this.#s}}const DE=4e3,Dd=9;class NE{constructor(t){this.giveBackFocus=t}#t=mt("edit-bar");#e=mt("edit-said");#n=mt("edit-palette");#i=mt("edit-undo");#s=mt("edit-waiting");#r=[...document.querySelectorAll("[data-edit-tool]")];#o=[mt("edit-open"),mt("thumb-edit")];#a;#u=null;#h;attach(t){this.#a=t;const e=(n,s)=>n.addEventListener("click",()=>{s(),this.giveBackFocus()});for(const n of this.#o)e(n,()=>void t.toggle());e(mt("edit-close"),()=>void t.toggle());for(const n of this.#r)e(n,()=>t.choose(n.dataset.editTool));e(this.#i,()=>t.undo()),e(this.#n,()=>{}),this.#n.addEventListener("click",({target:n})=>{const s=n.closest("[data-material]");s!==null&&t.chooseMaterial(Number(s.dataset.material))}),this.show()}show(){const{isOn:t,tool:e,material:n,palette:s,whyNot:r,canUndo:a}=this.#a;this.#t.hidden=!t,document.body.classList.toggle("editing",t);for(const o of this.#o)o.setAttribute("aria-pressed",String(t)),o.setAttribute("aria-disabled",String(r!==null)),o.title=r??"";for(const o of this.#r)o.setAttribute("aria-pressed",String(o.dataset.editTool===e));this.#i.disabled=!a,this.#u!==s&&(this.#u=s,this.#n.replaceChildren(...s.map(({id:o,name:l,colour:c},h)=>{const u=An("button");u.type="button",u.dataset.material=String(o),u.setAttribute("aria-label",h<Dd?`${l}, key ${h+1}`:l),u.title=l;const d=An("i");return o!==0?d.style.background="#"+c.toString(16).padStart(6,"0"):d.className="air",u.append(d),h<Dd&&u.append(An("span",String(h+1))),u})));for(const o of this.#n.children){const l=o.dataset.material===String(n);o.setAttribute("aria-pressed",String(l)),l&&t&&o.scrollIntoView({block:"nearest",inline:"nearest"})}re(mt("edit-material"),s.find(({id:o})=>o===n)?.name??"")}say(t,e){re(this.#e,t),this.#e.classList.toggle("bad",e),this.#e.hidden=t==="",clearTimeout(this.#h),this.#h=setTimeout(()=>this.#e.hidden=!0,DE)}waits(t){this.#s.hidden=t===0,t>0&&re(this.#s,`${t} ${t===1?"edit waits":"edits wait"} for the server`)}}function UE(i,{eye:t,ahead:e}){const n=r=>()=>{i.isOn&&r()},s={KeyV:()=>void i.toggle(),KeyR:n(()=>i.nextTool()),KeyZ:n(()=>i.undo()),KeyI:n(()=>i.sample(t(),e())),KeyJ:n(()=>i.turn(-1)),KeyL:n(()=>i.turn(1)),Backspace:n(()=>i.act(t(),e(),i.tool!=="dig"))};for(let r=1;r<=9;++r)s[`Digit${r}`]=n(()=>i.chooseSwatch(r-1));return s}function FE(i,t){addEventListener("keydown",e=>{const n=e.target instanceof HTMLElement&&/^(INPUT|TEXTAREA|SELECT)$/.test(e.target.tagName);e.code!=="KeyZ"||!(e.ctrlKey||e.metaKey)||e.shiftKey||n||!i.isOn||t()||(e.preventDefault(),i.undo())})}const OE=.25,Nd=20;class kE{constructor(t){this.turns=t}#t=0;#e=0;#n=0;#i=[];start(){const t=e=>{requestAnimationFrame(t),this.turns.step(e,Math.min(OE,Math.max(0,(e-this.#t)/1e3))),this.#t=e,this.#s();const n=this.turns.cap();n>0&&e-this.#e<1e3/n-1||(this.#e=e,this.#i.push(e),this.#i.length>60&&this.#i.shift(),this.turns.draw(e))};requestAnimationFrame(t),setInterval(()=>{performance.now()-this.#n>=Nd&&this.#s()},Nd)}#s(){this.turns.update(),this.#n=performance.now()}get framesPerSecond(){const[t,e]=[this.#i[0],this.#i.at(-1)];return t===void 0||e===void 0||e===t?0:(this.#i.length-1)*1e3/(e-t)}}const BE=500,zE=10;class GE{#t=0;#e=0;#n="";#i="";follow(t,e){if(t-this.#t<BE)return;this.#t=t;const n=_h(e,location.hash),s=n===this.#n;this.#n=n,n!==this.#i&&(s||++this.#e>=zE)&&this.#s(n)}write(t){this.#s(_h(t,location.hash))}#s(t){this.#e=0,t!==this.#i&&(this.#i=t,history.replaceState(history.state,"",t))}}const HE=600,VE=2,Ud=4;function WE({memory:i,isCoarse:t,shortSide:e}){return i!==null&&i<=VE?{radius:6,horizon:2048}:t&&(e<HE||i===null||i<=Ud)||i!==null&&i<=Ud?{radius:10,horizon:4096}:null}function Tp(i,t){if(t===null)return i;const e={...i};for(const n of["radius","horizon"])e[n]!==void 0&&(e[n]=Math.min(e[n],t[n]));return e}function XE(){const{deviceMemory:i}=navigator;return{memory:i??null,isCoarse:matchMedia("(pointer: coarse)").matches,shortSide:Math.min(screen.width,screen.height)}}const Fd=(...i)=>t=>i.includes(t),Jr=(i,t)=>e=>typeof e=="number"&&e>=i&&e<=t,Qr=i=>typeof i=="boolean",pc={radius:Jr(2,24),horizon:Jr(0,16384),quality:Fd("low","high"),transport:Fd("websocket","http"),frameRate:Jr(0,240),sensitivity:Jr(.02,1),invertLook:Qr,timeRuns:Qr,chunkBorders:Qr,reducedMotion:i=>i===null||Qr(i)};function Ap(i){return{radius:i?6:10,horizon:i?2048:4096,quality:i?"low":"high",transport:"websocket",frameRate:0,sensitivity:.12,invertLook:!1,timeRuns:!1,chunkBorders:!1,reducedMotion:null}}function Kc(i,t){const e={...i};if(typeof t=="object"&&t!==null)for(const[n,s]of Object.entries(t))n in pc&&pc[n](s)&&(e[n]=s);return e}function qE(i){const t={};for(const[e,n]of new URLSearchParams(i.replace(/^#/,"")))e in pc&&(t[e]=n==="true"?!0:n==="false"?!1:/^\d+(\.\d+)?$/.test(n)?Number(n):n);return t}const Rp="talus.settings";function $E(i,t){try{return Kc(i,JSON.parse(t().getItem(Rp)??"null"))}catch{return i}}function YE(i,t){try{t().setItem(Rp,JSON.stringify(i))}catch{}}const KE=14,ZE=16;class JE{constructor(t,e,n){this.body=t,this.server=e,this.engine=n}isPlaced=!1;#t=!1;#e=!1;#n=null;place(t){const[e,n,s]=this.body.position,{yaw:r,pitch:a,mode:o}=this.body;return{x:e,y:n,z:s,yaw:r,pitch:a,time:t,mode:o}}async to(t,e,n){this.#s(t,e??await this.#i(t,n),n,e===null)}async#i(t,e){return Math.max(await this.server.ground(t,e),this.engine()?.world.seaLevel??-1/0)+this.#o}#s(t,e,n,s){this.body.place(t,e,n),this.#t=s,this.#e=!s,this.isPlaced=!0}toSpawn(){const t=this.engine();if(t===null)return;const{x:e,y:n,z:s}=t.world.spawn;this.body.place(e+.5,n+this.#o,s+.5),this.#t=this.#e=!1,this.#n=null,this.isPlaced=!0}async lookOut(){const t=this.place(0);let e=t.yaw;try{e=await this.server.outlook(t.x,t.z)}catch{}this.#r(t)&&(this.body.yaw=e,this.#n=this.place(0))}turnFromWhatIsNear(t){const e=this.#n;if(e!==null){if(this.#r(e)){const n=(r,a,o)=>t.voxelAt(r,a,o),s=Xp(this.body.eye,e.yaw,e.pitch,n,r=>t.isSolid(r));if(s===void 0)return;this.body.yaw=s}this.#n=null}}#r(t){const e=this.place(0);return["x","y","z","yaw","pitch"].every(n=>e[n]===t[n])}surface(t){if(!this.#t)return;const[e,n,s]=this.body.position,r=o=>t.voxelAt(Math.floor(e),o,Math.floor(s));let a=Math.floor(n);for(;t.isLiquid(r(a)??0);)++a;r(a)!==void 0&&(this.#t=!1,a>n&&this.body.place(e,a+this.#o,s))}emerge(){if(!this.#e)return;const{isBuried:t,position:e}=this.body;if(t===void 0||(this.#e=!1,!t||this.body.rise(ZE)))return;const[n,s,r]=e;this.#i(n,r).then(a=>{const o=this.body.position;o[0]===n&&o[1]===s&&o[2]===r&&this.#s(n,a,r,!0)}).catch(()=>{})}get#o(){return this.body.mode==="fly"?KE:0}}const QE=12e3;class jE{#t=mt("hint");#e=!1;#n=null;constructor(t){mt("hint-close").addEventListener("click",()=>{this.#e=!0,this.#t.hidden=!0,t()})}tick(t,e,n){if(this.#e)return;const s=this.#t.matches(":hover, :focus-within");!e||s?this.#n=null:this.#n??=t,this.#e=n||this.#n!==null&&t-this.#n>QE,this.#t.hidden!==this.#e&&(this.#t.hidden=this.#e)}}const ks=60,tb=new Intl.NumberFormat("en",{maximumFractionDigits:0}),Wn=i=>tb.format(Math.round(i));function jr(i){if(i<1e3)return`${Math.round(i)} B`;for(const t of["kB","MB","GB"])if(i/=1e3,i<1e3||t==="GB")return`${i<10?i.toFixed(2):i<100?i.toFixed(1):Math.round(i)} ${t}`;return""}const Bs=i=>i<10?i.toFixed(1):String(Math.round(i)),eb={connecting:"connecting",streaming:"streaming",complete:"complete",lost:"server away",refused:"refused"};class nb{#t=new Map;#e=[];#n=0;#i=0;#s=0;update(t,e,n,s){const r=Math.floor(e/1e3);if(r!==this.#n&&(this.#n=r,this.#s=Math.max(0,t.receivedBytes-this.#i),this.#i=t.receivedBytes,this.#e.push(t.chunkRate),this.#e.length>ks&&this.#e.shift()),!s)return;const{latency:a,frameCpu:o}=t;this.#r("View",eb[t.state]),this.#r("Chunks",`${Wn(t.chunks)}, ${Wn(t.chunkRate)} /s`),this.#r("Received",`${jr(t.receivedBytes)}, ${jr(this.#s)}/s`),this.#r("Asked to drawn, p50",a===null?"–":`${Bs(a.p50)} ms`),this.#r("p95, p99",a===null?"–":`${Bs(a.p95)}, ${Bs(a.p99)} ms`),this.#r("Land is missing",t.nearestMissing===null?"nowhere":`${Wn(t.nearestMissing)} blocks away`),this.#r("Meshes, to come",`${Wn(t.meshes)}, ${Wn(t.pendingMeshes)}`),this.#r("Triangles",Wn(t.triangles)),this.#r("Draw calls",Wn(t.drawCalls)),this.#r("Pictures a second",n.toFixed(0)),this.#r("Frame, p50, p95",`${Bs(o.p50)}, ${Bs(o.p95)} ms`),this.#r("On the card, in the page",`${jr(t.gpuBytes)}, ${jr(t.heapBytes)}`),this.#o(),this.#a(t.chunksPerLevel)}#r(t,e){let n=this.#t.get(t);n===void 0&&(n=An("dd"),this.#t.set(t,n),mt("traffic").append(An("dt",t),n)),re(n,e)}#o(){const t=Math.max(1,...this.#e),e=this.#e.map((s,r)=>`${(r+ks-this.#e.length)*(120/(ks-1))} ${30-s/t*28}`);if(e.length<2)return;const n=(ks-this.#e.length)*(120/(ks-1));mt("traffic-chart").querySelector(".line").setAttribute("d",`M${e.join("L")}`),mt("traffic-chart").querySelector(".area").setAttribute("d",`M${n} 32L${e.join("L")}L120 32z`)}#a(t){const e=mt("traffic-levels"),n=Math.max(1,...t);for(;e.childElementCount<t.length;){const s=An("li"),r=e.childElementCount;s.append(An("span",r===0?"Full detail":`1 : ${2**r}`),An("meter"),An("span")),e.append(s)}t.forEach((s,r)=>{const[a,o,l]=e.children[r].children;o.max=n,o.value=s,o.setAttribute("aria-label",`${a.textContent}: ${s} chunks`),re(l,Wn(s))})}}function Cp(i){return i.state==="complete"?1:i.chunks===0?null:Math.min(.99,Math.max(0,i.chunks-i.pendingMeshes)/i.chunksWanted)}class ib{#t=mt("opening");#e=mt("hint").querySelector(".to-mode");opening(t,e){re(mt("opening-text"),t);const n=mt("opening-progress");e===null?n.removeAttribute("value"):n.value=e}opened(){this.#t.classList.add("gone"),mt("opening-progress").value=1,this.#t.removeAttribute("role")}status(t,e){re(mt("status-text"),t);const n=mt("status");n.dataset.state!==e&&(n.dataset.state=e)}connection(t){if(t.state==="lost")return this.status("Server away","bad");if(t.state==="refused")return this.status("Refused","bad");if(t.state==="connecting")return this.status("Connecting","busy");if(t.state==="complete")return this.status("All here","good");const e=Cp(t),n=t.chunksWanted>0&&t.chunks>=t.chunksWanted?"Drawing":"Receiving";this.status(e===null?n:`${n} ${Math.floor(e*100)} %`,"busy")}where(t,e){const[n,s,r]=[t.x,t.y??0,t.z].map(Math.floor);re(mt("where-at"),`${n}, ${s}, ${r}`);const a=e.waiting?"waiting for the land":e.mode==="fly"?`flying ${xh(t.yaw)}`:`${e.swimming?"swimming":"walking"} ${xh(t.yaw)}`;re(mt("where-way"),a),re(mt("where-speed"),e.mode==="fly"&&!e.waiting?`, ${Wn(e.flySpeed)} blocks/s`:""),re(this.#e,e.mode==="fly"?"walk":"fly")}}function sb(i){const t=()=>i.classList.toggle("more",i.scrollHeight-i.scrollTop-i.clientHeight>8);i.addEventListener("scroll",t,{passive:!0});const e=new ResizeObserver(t);e.observe(i);for(const n of i.children)e.observe(n)}class rb{constructor(t){this.answers=t}#t=mt("notice");#e=mt("notice-text");#n=null;#i="";trouble(t){if(this.#n=null,t===null){this.#t.dataset.kind!=="world"&&this.hide();return}switch(t.kind){case"away":this.#i=t.text,this.#n=t.retryAt,this.#s("away","The server is away","",[["Try now",this.answers.retry]]),this.tick(performance.now());break;case"token":this.#s("token","The server asks for a token",t.text,[["Give a token",()=>this.answers.askToken(t.text)]]),this.answers.askToken(t.text);break;case"refused":this.#s("refused","The server refuses",t.text,[["Try again",this.answers.again]]);break;case"no-socket":this.#s("no-socket","The land does not come",t.text,[["Take it by HTTP",this.answers.byHttp],["Try again",this.answers.reload]]);break;case"no-webgl":this.#s("no-webgl","This browser shows no 3D here",`${nl(t.text)} The map works without.`,[["Open the map",()=>location.assign("map.html"+location.hash)],["Try again",this.answers.reload]]);break;case"graphics-lost":this.#s("graphics-lost","The system took the graphics away","The picture comes back in a moment.",[["Now",this.answers.reload]])}}worldChanged(){this.#s("world","This is another world now","The server has a new one. You stand at the same coordinate in it.",[["Go to its spawn",()=>(this.answers.toSpawn(),this.hide())],["Stay",()=>this.hide()]])}hide(){this.#t.hidden=!0,delete this.#t.dataset.kind}tick(t){if(this.#t.dataset.kind!=="away")return;const e=this.#n===null?null:Math.max(0,Math.ceil((this.#n-t)/1e3)),n=e===null||e===0?"Trying again.":`Trying again in ${e} s.`,s=this.#i===""?"":nl(this.#i)+" ";re(this.#e,s+n)}#s(t,e,n,s){this.#t.dataset.kind=t,re(mt("notice-title"),e),re(this.#e,n===""?"":nl(n)),mt("notice-actions").replaceChildren(...s.map(([r,a])=>{const o=An("button",r);return o.type="button",o.addEventListener("click",a),o})),this.#t.hidden=!1}}const nl=i=>i.charAt(0).toUpperCase()+i.slice(1)+(/[.!?]$/.test(i)?"":".");class ab{constructor(t){this.giveBackFocus=t;for(const e of document.querySelectorAll("[data-panel]")){const n=e.dataset.panel;this.#e.set(n,e),e.setAttribute("aria-expanded","false"),e.setAttribute("aria-controls",`panel-${n}`),e.addEventListener("click",()=>this.toggle(n))}}#t=null;#e=new Map;onOpen=new Map;isOpen(t){return this.#t===t}get isAnyOpen(){return this.#t!==null}toggle(t,e=!0){const n=this.#t!==t;if(this.close(!1),!n)return this.giveBackFocus();this.#t=t;const s=mt(`panel-${t}`);s.hidden=!1,this.#e.get(t).setAttribute("aria-expanded","true"),document.exitPointerLock?.(),this.onOpen.get(t)?.(),e&&s.querySelector("input, button, select")?.focus({preventScroll:!0})}close(t=!0){return this.#t===null?!1:(mt(`panel-${this.#t}`).hidden=!0,this.#e.get(this.#t).setAttribute("aria-expanded","false"),this.#t=null,t&&this.giveBackFocus(),!0)}}const ta={radius:({radius:i})=>`${i} chunks`,horizon:({horizon:i})=>i===0?"none":`${(i/1e3).toFixed(1)} km`,sensitivity:({sensitivity:i})=>`${Math.round(i*100)}`};class ob{constructor(t,e,n,s){this.settings=t,s!==null&&this.#e(s),this.#t.addEventListener("submit",r=>r.preventDefault()),this.#t.addEventListener("input",r=>{const a=r.target,o=a instanceof HTMLInputElement&&a.type==="checkbox"?String(a.checked):a.value,l=o==="null"?null:o==="true"?!0:o==="false"?!1:Number.isNaN(Number(o))?o:Number(o),c=Kc(t,{[a.name]:l}),h=a.name;c[h]!==t[h]&&e({[h]:c[h]}),this.show()}),mt("settings-reset").addEventListener("click",()=>{e(Ap(n)),this.show()}),this.show()}#t=mt("settings");#e(t){for(const r of["radius","horizon"])this.#t.elements.namedItem(r).max=String(t[r]);const e=mt("settings-cap");e.hidden=!1;const[n,s]=[ta.radius(t),ta.horizon(t)];re(e,`On this device at most ${n} of full detail and a horizon of ${s}: more would take memory that it may not have.`)}show(){for(const[t,e]of Object.entries(this.settings)){const n=this.#t.elements.namedItem(t);n instanceof HTMLInputElement&&n.type==="checkbox"?n.checked=e:n instanceof HTMLInputElement?n.value=String(e):n instanceof HTMLSelectElement&&([...n.options].some(s=>s.value===String(e))||n.add(new Option(String(e))),n.value=String(e)),t in ta&&re(mt(`${t}-now`),ta[t](this.settings))}}}class lb{constructor(t,e,n){this.picture=t,this.place=e,mt("save-picture").addEventListener("click",()=>void this.save()),mt("copy-link").addEventListener("click",async()=>{n();try{await navigator.clipboard.writeText(location.href),this.#t("The link is copied.")}catch{this.#t("This browser does not let the page copy; the address above is the link.")}})}async save(){const t=this.picture();if(t===null)return this.#t("There is no picture yet.");const e=URL.createObjectURL(await t),{x:n,z:s}=this.place(),r=document.createElement("a");r.href=e,r.download=`talus_${Math.round(n)}_${Math.round(s)}.png`,r.click(),URL.revokeObjectURL(e),this.#t(`Saved as ${r.download}.`)}#t(t){re(mt("share-said"),t)}}const cb=4,Lp=256,hb=96,ub=i=>Math.round(Math.min(Lp,Math.max(cb,i??hb)));function Od(i,t){const e=i.yaw*Math.PI/180;return{x:i.x+Math.sin(e)*t,z:i.z-Math.cos(e)*t,yaw:e+Math.PI}}class db{constructor(t,e){this.standNow=t,this.apply=e,this.#t.addEventListener("change",()=>this.#t.checked?this.cutHere():this.#s()),this.#e.addEventListener("input",()=>this.#s()),this.#n.addEventListener("input",()=>{const{x:n,z:s}=Od(this.#i,Number(this.#e.value));this.#i={x:n,z:s,yaw:Number(this.#n.value)},this.#e.value="0",this.#s()}),mt("slice-here").addEventListener("click",()=>this.cutHere()),this.#s()}#t=mt("slice-on");#e=mt("slice-distance");#n=mt("slice-yaw");#i={x:0,z:0,yaw:0};get slice(){return this.#t.checked?Od(this.#i,Number(this.#e.value)):null}cutHere(){const{x:t,z:e,yaw:n,seen:s}=this.standNow();this.#i={x:t,z:e,yaw:Math.round(qp(n))%360},this.#e.value=String(ub(s)),this.#n.value=String(this.#i.yaw),this.#t.checked=!0,this.#s()}off(){this.#t.checked=!1,this.#s()}move(t){if(!this.#t.checked)return this.cutHere();this.#e.value=String(Number(this.#e.value)+t),this.#s()}#s(){re(mt("slice-distance-now"),`${this.#e.value} blocks`),re(mt("slice-yaw-now"),`${this.#n.value}°`),mt("slice-said").hidden=!this.#t.checked,this.apply(this.slice)}}const kd=256,Pp=70,zs=Math.PI/180;function Zc(i,t,e,n){const s=Math.tan(Pp/2*zs),[r,a]=[Math.sin(i*zs),Math.cos(i*zs)],[o,l]=[Math.sin(t*zs),Math.cos(t*zs)],[c,h]=[e*s,n*s],u=l-h*o,[d,f,m]=[r*u+a*c,o+h*l,-a*u+r*c],x=Math.hypot(d,f,m);return{x:d/x,y:f/x,z:m/x}}class fb{#t=mt("voxel");#e=mt("voxel-close");#n=null;#i=null;constructor(){this.#e.addEventListener("click",()=>this.letGo())}get held(){return this.#n}get shown(){return this.#i}look(t,e,n,s){this.#n===null&&this.#s(t,t.raycast(e,Zc(n,s,0,0),kd,!0))}hold(t,e,n){this.#n=t.raycast(e,n,kd,!0),this.#e.hidden=this.#n===null,this.#s(t,this.#n)}letGo(){const t=this.#n!==null;return this.#n=null,this.#e.hidden=!0,t}clear(){this.letGo(),this.#i=null,this.#t.hidden=!0}#s(t,e){const n=e!==null&&this.#i!==null&&e.x===this.#i.x&&e.y===this.#i.y&&e.z===this.#i.z&&e.material===this.#i.material;if(!n&&(e!==null||this.#i!==null)&&t.setSelection(e),n||(this.#i=e,this.#t.hidden=e===null,e===null))return;const s=t.world.materials.find(({id:r})=>r===e.material);re(mt("voxel-name"),s?.name??`material ${e.material}`),re(mt("voxel-at"),`${e.x}, ${e.y}, ${e.z}`),mt("voxel-colour").style.background="#"+(s?.colour??0).toString(16).padStart(6,"0"),this.#t.dataset.material=String(e.material)}}const Ip=XE(),Jc=Ip.isCoarse,Qc=WE(Ip),Dp=matchMedia("(prefers-reduced-motion: reduce)"),Np=()=>localStorage,pb=1440,mb=-8;let ga=$E(Ap(Jc),Np);const Re=Tp(Kc(ga,qE(location.hash)),Qc),mc=()=>Re.reducedMotion??Dp.matches,jc=new $p,th=new Yp(location.href,()=>jc.token),ze=new vE,{body:fe}=ze,eh=new GE,Un=mt("stage");let jt=null,In=Sc(location.hash).time??10.5;const _e=new JE(fe,th,()=>jt),fs=()=>_e.place(In);function Up(i){fe.mode=i.mode??fe.mode,fe.yaw=i.yaw??fe.yaw,fe.pitch=i.pitch??fe.pitch,i.time!==void 0&&ps(i.time),i.x!==void 0&&i.z!==void 0?_e.to(i.x,i.y??null,i.z).catch(t=>{vn.status(t.message,"bad"),_e.isPlaced||_e.toSpawn()}):_e.isPlaced||(_e.toSpawn(),i.yaw===void 0&&_e.lookOut())}addEventListener("hashchange",()=>Up(Sc(location.hash)));addEventListener("pagehide",()=>{_e.isPlaced&&eh.write(fs())});const gc=mt("time"),ka=mt("time-runs");function ps(i){In=Qp(i),jt?.setTimeOfDay(In),gc.value=String(In),re(mt("time-now"),jp(In))}gc.addEventListener("input",()=>ps(Math.min(23.99,Number(gc.value))));ka.checked=Re.timeRuns;ka.addEventListener("change",()=>or({timeRuns:ka.checked}));function or(i){const t=Tp(i,Qc);Object.assign(Re,t),ga={...ga,...t},YE(ga,Np),"transport"in t&&Fi.open(),("radius"in t||"horizon"in t)&&jt?.setRadius(Re.radius,Re.horizon),"quality"in t&&(jt?.setQuality(Re.quality),sh()),"reducedMotion"in t&&Ya(),"chunkBorders"in t&&nh(),ka.checked=Re.timeRuns}function Ya(){jt?.setReducedMotion(mc()),document.body.classList.toggle("moves",!mc())}Dp.addEventListener("change",Ya);const vc=mt("borders");function nh(){vc.checked=Re.chunkBorders,jt?.setChunkBorders(Re.chunkBorders)}vc.addEventListener("change",()=>or({chunkBorders:vc.checked}));const _s=()=>Un.focus({preventScroll:!0}),Cn=new ab(_s),vn=new ib,gb=new jE(_s),vb=new nb,Ui=new fb,ss=new db(()=>({x:fe.position[0],z:fe.position[2],yaw:fe.yaw,seen:xb()}),i=>jt?.setSlice(i));new ob(Re,or,Jc,Qc);new lb(()=>jt?.screenshot()??null,fs,()=>eh.write(fs()));const Fp=new Kp(jc,()=>{Fi.again(),Pe.ask()});mt("token-change").addEventListener("click",()=>Fp.ask("The next connection uses it."));const ih=mt("help");for(const i of document.querySelectorAll(".panel, #help, #notice"))sb(i);const _c=()=>{document.exitPointerLock?.(),ih.showModal()};mt("open-help").addEventListener("click",_c);ih.addEventListener("close",_s);mt("goto-form").addEventListener("submit",i=>{i.preventDefault();const t=Zp(mt("goto-text").value),e=mt("goto-wrong");if(t===null)return re(e,"Two or three numbers, such as 1200 -340 or 1200 90 -340.");re(e,""),_e.to(t.x,t.y,t.z).then(()=>Cn.close(),n=>re(e,n.message))});mt("goto-spawn").addEventListener("click",()=>(_e.toSpawn(),Cn.close()));const Ba=new NE(_s),Pe=new IE(fe,{changed:()=>Ba.show(),say:(i,t)=>Ba.say(i,t)});Ba.attach(Pe);const xc=new rb({retry:()=>Fi.hurry(),again:()=>Fi.again(),reload:()=>void Fi.open(),byHttp:()=>or({transport:"http"}),askToken:i=>Fp.ask(i),toSpawn:()=>_e.toSpawn()}),Fi=new eE(Un,Re,th,jc,mc,{opened(i){jt=i,document.body.classList.remove("empty"),ze.enter(i),Pe.enter(i),i.setFov(Pp),sh(),i.setTimeOfDay(In),i.setSlice(ss.slice),Ya(),nh(),_e.isPlaced||Up(_b()),vn.opening("The land is on its way",null),re(mt("help-world"),`${i.world.server}, world ${i.world.fingerprint}`)},closing(){jt=null,document.body.classList.add("empty"),ze.enter(null),Pe.enter(null),Ui.clear()},trouble(i){if(xc.trouble(i),i===null)return;const t={away:"Server away",token:"No access",refused:"Refused","no-socket":"No connection","no-webgl":"No 3D","graphics-lost":"No graphics"};vn.status(t[i.kind],"bad"),i.kind==="away"?vn.opening("Waiting for the server",null):vn.opened()},worldChanged(i){Ui.clear(),Pe.enter(jt),re(mt("help-world"),`${i.server}, world ${i.fingerprint}`),xc.worldChanged()}});function _b(){const i=Sc(location.hash);return{pitch:mb,mode:"fly",...i}}function sh(){const i=Math.min(devicePixelRatio,Re.quality==="high"?2:1);jt?.resize(Un.clientWidth,Un.clientHeight,i)}addEventListener("resize",sh);const ms=()=>{const[i,t,e]=fe.eye;return{x:i,y:t,z:e}};function Ka(i,t,e=!1){if(jt===null)return;const n=Un.clientHeight/2,s=Zc(fe.yaw,fe.pitch,(i-Un.clientWidth/2)/n,1-t/n);Pe.isOn?Pe.act(ms(),s,e):Ui.hold(jt,ms(),s)}function xb(){const i=jt?.raycast(ms(),rh.ahead(),Lp,!0)??null;return i===null||i.distance===0?null:i.distance*Math.cos(fe.pitch*Math.PI/180)}const wb=()=>Ka(Un.clientWidth/2,Un.clientHeight/2),rh={eye:ms,ahead:()=>Zc(fe.yaw,fe.pitch,0,0)},wc=i=>ze.changeSpeed(i),Sb=(i,t)=>Pe.isOn&&!t?Pe.turn(-i):wc(i),Mb={...UE(Pe,rh),KeyF:()=>ze.toggleMode(),KeyM:()=>kp(),KeyG:()=>Cn.toggle("goto"),KeyT:()=>Cn.toggle("time"),KeyX:()=>ss.slice===null?ss.cutHere():ss.off(),BracketLeft:()=>ss.move(-1),BracketRight:()=>ss.move(1),KeyP:()=>Cn.toggle("traffic",!1),KeyB:()=>or({chunkBorders:!Re.chunkBorders}),KeyK:()=>Cn.toggle("share"),KeyO:()=>Cn.toggle("settings"),KeyU:()=>document.body.classList.toggle("bare"),KeyH:_c,"?":_c,Home:()=>fe.pitch=0,Comma:()=>ps(In-.25),Period:()=>ps(In+.25),"+":()=>wc(1),"-":()=>wc(-1),Enter:()=>Pe.isOn||Ui.held===null?wb():Ui.letGo(),Escape:()=>Cn.close()||Pe.cancel()||Ui.letGo()},Op=()=>ih.open||mt("token").open||!mt("map").hidden;ze.add(new iE(Mb,Op));FE(Pe,Op);ze.add(new rE(Un,Re,Ka,Sb,()=>Pe.isOn));const ah=new wE(Un,mt("stick"),Re,Ka,()=>{document.body.classList.add("touched"),mt("thumbs").hidden=!1});ah.hold(mt("thumb-up"),1);ah.hold(mt("thumb-down"),-1);mt("thumb-mode").addEventListener("click",()=>ze.toggleMode());ze.add(ah);Jc&&(document.body.classList.add("touched"),mt("thumbs").hidden=!1);addEventListener("blur",()=>ze.release());async function kp(){document.exitPointerLock?.(),ze.release();const{openMapOverlay:i}=await nm(async()=>{const{openMapOverlay:t}=await import("./overlay-B4opBDkl.js");return{openMapOverlay:t}},__vite__mapDeps([0,1,2,3]),import.meta.url);i(mt("map"),th,{place:fs,world:()=>jt?.world??null,go:(t,e)=>_e.to(t,null,e),closed:_s})}mt("open-map").addEventListener("click",()=>void kp());let Bd=0,zd=0,il=!1;const Bp=new kE({cap:()=>yb()?0:Re.frameRate,step(i,t){Re.timeRuns&&ps(In+t*24/pb),_e.isPlaced&&ze.step(t),jt!==null&&_e.isPlaced&&(_e.surface(jt),_e.emerge(),_e.turnFromWhatIsNear(jt),ze.look(jt),Pe.look(ms(),rh.ahead()),i-zd>100&&(zd=i,Ui.look(jt,ms(),fe.yaw,fe.pitch)),eh.follow(i,fs())),i-Bd>250&&(Bd=i,Eb(i))},update(){jt!==null&&_e.isPlaced&&jt.update()},draw(i){jt!==null&&_e.isPlaced&&jt.frame(i)}});function yb(){if(il||jt===null)return!1;const i=jt.stats();return il=i.hasPicture,i.meshes>0&&!il}function Eb(i){if(xc.tick(i),jt===null)return;const t=jt.stats();im(t,Fi.began),vn.connection(t),Ba.waits(t.state==="lost"?Pe.waiting:0),vn.where(fs(),fe),t.hasPicture||t.state==="complete"?vn.opened():vn.opening("The land is on its way",Cp(t)),gb.tick(i,t.state==="complete"&&!Cn.isAnyOpen,ze.hasMoved),vb.update(t,i,Bp.framesPerSecond,Cn.isOpen("traffic"))}ps(In);Ya();nh();Jp();vn.opening("Connecting",null);vn.status("Connecting","busy");_s();Bp.start();Fi.open();window.talus={get engine(){return jt},player:ze,settings:Re,builder:Pe,pick:Ka};
